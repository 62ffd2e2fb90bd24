#pragma once

#include <optional>
#include <string>

namespace synthetic_dataset::programs {

/// The files that are compiled into the programs: those of the set-up page, params.yaml and some of
/// the documentation. For the page's developers, files in a folder take precedence over these.
class EmbeddedFiles {
 public:
  /// @param folder  searched first; empty: only the compiled-in files
  explicit EmbeddedFiles(std::string folder = "");

  /// A file's content by its name; nothing if there is no such file.
  [[nodiscard]] std::optional<std::string> find(const std::string& name) const;

 private:
  std::string folder_;
};

/// A file's media type, by its name's extension.
[[nodiscard]] std::string mediaTypeOf(const std::string& name);

}  // namespace synthetic_dataset::programs

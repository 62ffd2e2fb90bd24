#pragma once

#include <optional>
#include <string>

namespace synthetic_dataset::programs {

/// The files that are part of the programs: those of the set-up page, params.yaml and some of the
/// documentation; or, for the page's developers, those in a folder instead of the page's.
class EmbeddedFiles {
 public:
  /// @param folder  empty: those of the program; else what it has comes first
  explicit EmbeddedFiles(std::string folder = "");

  /// A file's content by its name; nothing where there is none.
  [[nodiscard]] std::optional<std::string> find(const std::string& name) const;

 private:
  std::string folder_;
};

/// What kind of file it is, by its name.
[[nodiscard]] std::string mediaTypeOf(const std::string& name);

}  // namespace synthetic_dataset::programs

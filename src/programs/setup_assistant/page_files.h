#pragma once

#include <optional>
#include <string>

namespace synthetic_dataset::programs {

/// The files of the page: those that are part of the program, as are params.yaml and formats.md,
/// or, for its developers, those in a folder.
class PageFiles {
 public:
  /// @param folder  empty: those of the program
  explicit PageFiles(std::string folder = "");

  /// A file's content by its name; nothing where there is none.
  [[nodiscard]] std::optional<std::string> find(const std::string& name) const;

 private:
  std::string folder_;
};

/// What kind of file it is, by its name.
[[nodiscard]] std::string mediaTypeOf(const std::string& name);

}  // namespace synthetic_dataset::programs

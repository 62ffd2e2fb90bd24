#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace synthetic_dataset::programs {

/// The folders of this machine that the page may look into.
class AllowedFolders {
 public:
  /// @param file  the settings file, whose folder is the first one
  /// @param more  folders named by the user; those of ROS packages and of models are added
  /// @throws Error if one of `more` is not a folder
  AllowedFolders(const std::filesystem::path& file, const std::vector<std::string>& more);

  /// The roots, with links resolved.
  [[nodiscard]] const std::vector<std::filesystem::path>& roots() const { return roots_; }

  /// The folder below which the page may write files.
  [[nodiscard]] const std::filesystem::path& home() const { return roots_.front(); }

  /// A path with links and `..` resolved.
  /// @throws HttpError 403 when it lies in none of the folders, also when there is no such file
  [[nodiscard]] std::filesystem::path resolve(const std::filesystem::path& path) const;

  /// Whether a path without links lies in one of the folders.
  [[nodiscard]] bool holds(const std::filesystem::path& resolved) const;

 private:
  void add(const std::string& folder);
  void addListed(const char* variable);

  std::vector<std::filesystem::path> roots_;
};

/// Whether a path is the folder or lies below it; both are absolute and without links or `..`.
[[nodiscard]] bool isBelow(const std::filesystem::path& path, const std::filesystem::path& folder);

}  // namespace synthetic_dataset::programs

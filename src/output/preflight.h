#pragma once

#include <string>
#include <vector>

#include "output/dataset_store.h"

namespace synthetic_dataset::output {

/// Settings and places of writers that cannot be as they are: folders shared or nested, files that
/// two writers would make. All paths absolute and normalised.
[[nodiscard]] std::vector<std::string> layoutProblems(const std::string& manifest_file,
                                                      const std::vector<StoreWriter>& writers);

/// Makes folders, finds out by trying whether files can be made in them, and removes the folders
/// again at the end of its life unless they are kept.
class FolderProbe {
 public:
  FolderProbe() = default;
  FolderProbe(const FolderProbe&) = delete;
  FolderProbe& operator=(const FolderProbe&) = delete;
  ~FolderProbe();

  /// @param owner  for the message: "writer 'yolo'"
  void tryFolder(const std::string& owner, const std::string& folder);

  /// What did not work, naming owner, folder and reason.
  [[nodiscard]] const std::vector<std::string>& problems() const { return problems_; }

  /// Whether a file is what a probe leaves for a moment.
  [[nodiscard]] static bool isProbe(const std::string& path);

  void keepFolders() { made_.clear(); }

 private:
  std::vector<std::string> made_;  // parents first
  std::vector<std::string> problems_;
};

}  // namespace synthetic_dataset::output

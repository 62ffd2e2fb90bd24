#pragma once

#include <string>
#include <vector>

#include "output/dataset_store.h"

namespace synthetic_dataset::output {

/// Conflicts in the layout of the writers: shared or nested folders, files that two writers would
/// both make. All paths are absolute and normalised.
[[nodiscard]] std::vector<std::string> layoutProblems(const std::string& manifest_file,
                                                      const std::vector<StoreWriter>& writers);

/// Makes folders and tests whether files can be made in them. The destructor removes the folders
/// again unless they are kept.
class FolderProbe {
 public:
  FolderProbe() = default;
  FolderProbe(const FolderProbe&) = delete;
  FolderProbe& operator=(const FolderProbe&) = delete;
  ~FolderProbe();

  /// @param owner  for the message: "writer 'yolo'"
  void tryFolder(const std::string& owner, const std::string& folder);

  /// What failed, naming the owner, the folder and the reason.
  [[nodiscard]] const std::vector<std::string>& problems() const { return problems_; }

  /// Whether a file is the temporary file of a probe.
  [[nodiscard]] static bool isProbe(const std::string& path);

  void keepFolders() { made_.clear(); }

 private:
  std::vector<std::string> made_;  // parents first
  std::vector<std::string> problems_;
};

}  // namespace synthetic_dataset::output

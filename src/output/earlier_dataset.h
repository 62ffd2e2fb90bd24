#pragma once

#include <set>
#include <string>
#include <vector>

#include "output/dataset_store.h"
#include "output/manifest.h"

namespace synthetic_dataset::output {

/// What an earlier run left where a new one is to write.
class EarlierDataset {
 public:
  /// @param folder  of the manifest, absolute and normalised
  /// @throws Error when there is a manifest that cannot be read
  explicit EarlierDataset(const std::string& folder);

  /// What of it is in the new run's way, as messages: any dataset and any file that no manifest
  /// lists; only the latter when listed files may be overwritten.
  [[nodiscard]] std::vector<std::string> obstacles(const std::vector<StoreWriter>& writers,
                                                   IfExists if_exists) const;

  /// Removes the listed files, what a killed run left of them, folders of writers that are empty
  /// then, and at last the manifest.
  /// @throws Error for a file that cannot be removed
  void remove() const;

 private:
  [[nodiscard]] std::vector<std::string> unlistedFiles(const StoreWriter& writer) const;
  void removeEmptyFoldersAbove(const std::string& file) const;

  std::string folder_;
  bool exists_ = false;
  ManifestContent content_;
  std::set<std::string> known_files_;  // listed files and their temporary names
};

}  // namespace synthetic_dataset::output

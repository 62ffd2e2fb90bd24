#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "output/dataset_store.h"
#include "output/manifest/manifest_content.h"

namespace synthetic_dataset::output {

/// Files in a manifest that a run of these writers must not touch: outside the dataset's folder and
/// the writers' folders, and not named by the user.
/// @param folder  the dataset's, absolute
[[nodiscard]] std::vector<std::string> filesOutsideRun(const ManifestContent& content,
                                                       const std::string& folder,
                                                       const std::vector<StoreWriter>& writers);

/// What earlier runs left where a new one is to write: manifests, and files that none of them
/// lists.
class EarlierDataset {
 public:
  /// @param folder  of the manifest, absolute and normalised
  /// @param shard  of the new run
  /// @throws Error if a manifest cannot be read
  EarlierDataset(const std::string& folder, const std::optional<Shard>& shard);

  /// The manifest that the new run would resume, if there is one.
  [[nodiscard]] const ManifestContent* own() const { return own_ ? &*own_ : nullptr; }

  /// For a shard's run: the manifest of the whole run, if there is one.
  [[nodiscard]] const ManifestContent* whole() const { return whole_ ? &*whole_ : nullptr; }

  /// What stands in the way of starting a new run, as messages: any dataset, and any file that no
  /// manifest lists; only the latter if listed files may be overwritten.
  [[nodiscard]] std::vector<std::string> obstacles(const std::vector<StoreWriter>& writers,
                                                   IfExists if_exists, Source source) const;

  /// Removes what a new run replaces: the listed files, what a killed run left of them, the
  /// writers' folders that are then empty, and finally the manifests. The run of a shard removes
  /// only its own.
  /// @throws ErrorList for files that cannot be removed, or when a run is still writing one of them
  void remove() const;

 private:
  struct Listed {
    std::string manifest;
    ManifestContent content;
  };

  void know(const std::string& manifest, const ManifestContent& content);
  [[nodiscard]] std::vector<std::string> datasetsInTheWay(IfExists if_exists, Source source) const;
  /// Listed files that a run of these writers must not touch.
  [[nodiscard]] std::vector<std::string> foreignFiles(
      const std::vector<StoreWriter>& writers) const;
  [[nodiscard]] std::vector<std::string> unlistedFiles(const StoreWriter& writer) const;
  void removeOne(const Listed& listed) const;

  std::string folder_;
  std::optional<Shard> shard_;
  std::optional<ManifestContent> own_;
  std::optional<ManifestContent> whole_;
  std::vector<Listed> replaced_;       ///< what this run overwrites
  std::vector<std::string> shards_;    ///< manifests of other shards
  std::set<std::string> known_files_;  ///< manifests, listed files and their temporary names
};

}  // namespace synthetic_dataset::output

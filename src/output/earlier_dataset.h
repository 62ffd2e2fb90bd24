#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "output/dataset_store.h"
#include "output/manifest/manifest_content.h"

namespace synthetic_dataset::output {

/// Files that a manifest lists where a run of these writers has no business: outside of the
/// dataset's folder and the writers', and none that the user has named.
/// @param folder  the dataset's, absolute
[[nodiscard]] std::vector<std::string> foreignFilesOf(const ManifestContent& content,
                                                      const std::string& folder,
                                                      const std::vector<StoreWriter>& writers);

/// What earlier runs left where a new one is to write: their manifests, and files that none lists.
class EarlierDataset {
 public:
  /// @param folder  of the manifest, absolute and normalised
  /// @param shard  of the new run
  /// @throws Error when there is a manifest that cannot be read
  EarlierDataset(const std::string& folder, const std::optional<Shard>& shard);

  /// The manifest that the new run would go on with, if it is there.
  [[nodiscard]] const ManifestContent* own() const { return own_ ? &*own_ : nullptr; }

  /// The manifest of the whole run, to a shard of it, if it is there.
  [[nodiscard]] const ManifestContent* whole() const { return whole_ ? &*whole_ : nullptr; }

  /// What of it is in the way of a new run that begins, as messages: any dataset and any file that
  /// no manifest lists; only the latter when listed files may be overwritten.
  [[nodiscard]] std::vector<std::string> obstacles(const std::vector<StoreWriter>& writers,
                                                   IfExists if_exists, Source source) const;

  /// Removes what a new run replaces: the listed files, what a killed run left of them, folders of
  /// writers that are empty then, and at last the manifests. Of a shard's run only its own.
  /// @throws ErrorList for files that cannot be removed, or when a run is still writing one of them
  void remove() const;

 private:
  struct Listed {
    std::string manifest;
    ManifestContent content;
  };

  void know(const std::string& manifest, const ManifestContent& content);
  [[nodiscard]] std::vector<std::string> datasetsInTheWay(IfExists if_exists, Source source) const;
  /// Listed files that lie where a run of these writers has no business.
  [[nodiscard]] std::vector<std::string> foreignFiles(
      const std::vector<StoreWriter>& writers) const;
  [[nodiscard]] std::vector<std::string> unlistedFiles(const StoreWriter& writer) const;
  void removeOne(const Listed& listed) const;

  std::string folder_;
  std::optional<Shard> shard_;
  std::optional<ManifestContent> own_;
  std::optional<ManifestContent> whole_;
  std::vector<Listed> replaced_;       ///< what this run overwrites
  std::vector<std::string> shards_;    ///< manifests of shards, but not of this one
  std::set<std::string> known_files_;  ///< manifests, listed files and their temporary names
};

}  // namespace synthetic_dataset::output

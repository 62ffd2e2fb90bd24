#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/sqlite.h"
#include "output/manifest/manifest_schema.h"
#include "output/manifest/run_description.h"
#include "output/store_types.h"

namespace synthetic_dataset::output {

/// The content of an earlier run's manifest, read in one go.
struct ManifestContent {
  bool complete = false;
  bool is_current = false;       ///< whether its tables are this software's version, with the truth
  std::int64_t scene_count = 0;  ///< number of scenes that are there
  std::optional<Shard> shard;
  RunDescription run;
  std::vector<StoreWriter> writers;  ///< their folders are absolute; without user files
  std::vector<std::string> files;    ///< absolute
};

/// Whether to read the list of a dataset's files, which may be long.
enum class ManifestFiles { kRead, kLeftOut };

/// @param file  the absolute path of a manifest
/// @throws Error if it is not a manifest of a known version, or is damaged; if files are left out,
///     only what is read is checked
[[nodiscard]] ManifestContent readManifest(const std::string& file,
                                           ManifestFiles files = ManifestFiles::kRead);

/// Reads an open manifest of a known version, without the list of files.
/// @param folder  of the manifest, absolute
[[nodiscard]] ManifestContent readWithoutFiles(const base::SqliteDatabase& database,
                                               const std::string& folder);

/// The manifests of shards in a folder, in alphabetical order.
[[nodiscard]] std::vector<std::string> shardManifests(const std::string& folder);

}  // namespace synthetic_dataset::output

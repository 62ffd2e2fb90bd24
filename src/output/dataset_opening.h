#pragma once

#include <memory>
#include <string>
#include <vector>

#include "output/dataset_store.h"
#include "output/files/run_lock.h"
#include "output/manifest/manifest.h"

namespace synthetic_dataset::output {

/// A dataset that a run may write now.
struct OpenedDataset {
  std::string file;                    ///< its manifest
  std::unique_ptr<RunLock> lock;       ///< none where the dataset is complete already
  std::unique_ptr<Manifest> manifest;  ///< the same
};

/// Makes sure that a run can begin, or can go on with what is there, and only then removes what it
/// is to replace (`if_exists`).
/// @param options, writers  with absolute and normalised paths
/// @throws ErrorList as DatasetStore does
[[nodiscard]] OpenedDataset openDataset(const StoreOptions& options,
                                        const std::vector<StoreWriter>& writers,
                                        const RunDescription& run);

}  // namespace synthetic_dataset::output

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "output/dataset_store.h"
#include "output/files/run_lock.h"
#include "output/manifest/manifest.h"

namespace synthetic_dataset::output {

/// A dataset that the run may now write to.
struct OpenedDataset {
  std::string file;                    ///< path of its manifest
  std::unique_ptr<RunLock> lock;       ///< null if the dataset is already complete
  std::unique_ptr<Manifest> manifest;  ///< null if the dataset is already complete
};

/// The dataset that already exists where a run would write.
struct EarlierRun {
  bool complete = false;
  std::int64_t scene_count = 0;  ///< number of scenes already in it
  bool is_written = false;       ///< another run is writing it now; the other members are not set
  std::string fault = {};        ///< why its manifest cannot be read; the other members are not set

  /// Why the run cannot resume it: one line for each difference. Empty if it can.
  std::vector<std::string> differences = {};
};

/// Makes paths absolute and normalises them.
void makeAbsolute(StoreOptions& options, std::vector<StoreWriter>& writers);

/// Checks quickly, without looking at the dataset's files, what already exists. Changes nothing.
/// @param run  its OpenGL version need not be known yet
/// @return nothing if no run has started a dataset in the folder
[[nodiscard]] std::optional<EarlierRun> findEarlierRun(StoreOptions options,
                                                       std::vector<StoreWriter> writers,
                                                       RunDescription run);

/// Files from elsewhere in the places where a new run would write, which openDataset would refuse.
/// Empty if the run would resume a dataset, or if the existing dataset itself is in the way.
[[nodiscard]] std::vector<std::string> filesInTheWay(StoreOptions options,
                                                     std::vector<StoreWriter> writers);

/// Makes sure that a run can begin, or can resume what is there, and only then removes what the run
/// is to replace (`if_exists`).
/// @param options, writers  as left by makeAbsolute
/// @throws ErrorList as DatasetStore does
[[nodiscard]] OpenedDataset openDataset(const StoreOptions& options,
                                        const std::vector<StoreWriter>& writers,
                                        const RunDescription& run);

}  // namespace synthetic_dataset::output

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

/// A dataset that a run may write now.
struct OpenedDataset {
  std::string file;                    ///< its manifest
  std::unique_ptr<RunLock> lock;       ///< none where the dataset is complete already
  std::unique_ptr<Manifest> manifest;  ///< the same
};

/// The dataset that lies where a run is to write.
struct EarlierRun {
  bool complete = false;
  std::int64_t scene_count = 0;  ///< that are there
  bool is_written = false;       ///< another run writes it now; then nothing else is known
  std::string fault = {};        ///< why its manifest cannot be read; then nothing else is known

  /// Why the run cannot go on with it: what differs, a line each. Empty: it can.
  std::vector<std::string> differences = {};
};

/// Makes paths absolute and normalises them.
void makeAbsolute(StoreOptions& options, std::vector<StoreWriter>& writers);

/// Looks at what is there, without its files, which is quick, and changes nothing.
/// @param run  its OpenGL need not be known yet
/// @return nothing where no run has begun a dataset in the folder
[[nodiscard]] std::optional<EarlierRun> findEarlierRun(StoreOptions options,
                                                       std::vector<StoreWriter> writers,
                                                       RunDescription run);

/// Files of others where a new run's files go, as openDataset would refuse them; nothing where a
/// run would go on with a dataset, or where the dataset that is there is in the way itself.
[[nodiscard]] std::vector<std::string> filesInTheWay(StoreOptions options,
                                                     std::vector<StoreWriter> writers);

/// Makes sure that a run can begin, or can go on with what is there, and only then removes what it
/// is to replace (`if_exists`).
/// @param options, writers  as makeAbsolute leaves them
/// @throws ErrorList as DatasetStore does
[[nodiscard]] OpenedDataset openDataset(const StoreOptions& options,
                                        const std::vector<StoreWriter>& writers,
                                        const RunDescription& run);

}  // namespace synthetic_dataset::output

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "plugins/nuscenes/nuscenes_frames.h"
#include "plugins/nuscenes/nuscenes_options.h"
#include "plugins/shared/json.h"
#include "synthetic_dataset/label_writer.h"

/// nuScenes' tables for the frames of a whole dataset.
namespace synthetic_dataset::nuscenes {

/// Receives the records of a table.
using AddRecord = std::function<void(const Json& record)>;

/// A table's name and the function that makes its records.
struct Table {
  std::string name;
  std::function<void(const AddRecord& add)> make;
};

/// All tables.
/// @param dataset, frames  must outlive the result; frames are in the order of their scenes
[[nodiscard]] std::vector<Table> tablesOf(const DatasetInfo& dataset,
                                          const std::vector<Frame>& frames,
                                          const NuScenesOptions& options);

}  // namespace synthetic_dataset::nuscenes

#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "plugins/shared/cloud_files.h"
#include "synthetic_dataset/box_choice.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// What KITTI calls regions without labels.
inline constexpr const char* kDontCare = "DontCare";

/// The settings of a KITTI writer.
struct KittiOptions {
  std::map<std::string, std::string> types;  ///< KITTI's, by class
  BoxChoice box = BoxChoice::kVisible;
  bool dont_care = true;             ///< whether objects without a label become such regions
  bool velodyne = false;             ///< whether there are points of a scanner, made of the depth
  std::optional<std::size_t> lidar;  ///< whose points there are, in DatasetInfo::lidars
  std::string lidar_frame;           ///< its frame, and the global one
  std::string global_frame;
  CloudPositions positions = CloudPositions::kAtStamp;  ///< of the lidar's points
  std::int64_t min_points = 0;  ///< objects of which the lidar has fewer get no label
};

[[nodiscard]] KittiOptions readKittiOptions(Parameters& parameters, const DatasetInfo& dataset);

}  // namespace synthetic_dataset

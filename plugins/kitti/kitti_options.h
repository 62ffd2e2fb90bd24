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

/// KITTI's type for regions without labels.
inline constexpr const char* kDontCare = "DontCare";

/// The settings of a KITTI writer.
struct KittiOptions {
  std::map<std::string, std::string> types;  ///< KITTI's types, by class
  BoxChoice box = BoxChoice::kVisible;
  bool dont_care = true;             ///< whether objects without a label become DontCare regions
  bool velodyne = false;             ///< whether to write a scanner's points, made from the depth
  std::optional<std::size_t> lidar;  ///< that provides the points; index in DatasetInfo::lidars
  std::string lidar_frame;           ///< the lidar's frame
  std::string global_frame;
  CloudPositions positions = CloudPositions::kAtStamp;  ///< of the lidar's points
  std::int64_t min_points = 0;  ///< objects with fewer lidar points get no label
};

[[nodiscard]] KittiOptions readKittiOptions(Parameters& parameters, const DatasetInfo& dataset);

}  // namespace synthetic_dataset

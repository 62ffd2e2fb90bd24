#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "plugins/shared/cloud_files.h"
#include "synthetic_dataset/box_choice.h"

namespace synthetic_dataset {

/// The settings of a NuScenes writer.
struct NuScenesOptions {
  std::string version = "v1.0-trainval";  ///< the folder of the tables
  BoxChoice box = BoxChoice::kVisible;    ///< in image_annotations
  std::string image_format = "jpg";
  std::optional<std::size_t> lidar;                     ///< LIDAR_TOP; index in DatasetInfo::lidars
  CloudPositions positions = CloudPositions::kAtStamp;  ///< of its points
  bool lidarseg = true;                                 ///< whether to write each point's category
  std::int64_t min_points = 0;      ///< objects with fewer lidar points are not annotated
  std::int64_t keyframe_every = 1;  ///< every n-th instant of a motion is a sample, from its first
};

[[nodiscard]] NuScenesOptions readNuScenesOptions(Parameters& parameters,
                                                  const DatasetInfo& dataset);

/// Kinds of records that refer to one another.
enum class NuScenesTable {
  kCategory = 1,
  kSensor,
  kCalibratedSensor,
  kLog,
  kMap,
  kScene,
  kSample,
  kSampleData,
  kEgoPose,
  kInstance,
  kSampleAnnotation,
};

/// A record's token: 32 digits that do not depend on other records.
[[nodiscard]] std::string nuScenesToken(NuScenesTable table, std::int64_t first,
                                        std::int64_t second = 0);

/// The name of a camera's channel: CAM_FRONT if it is the only one, otherwise CAM_ and its name.
[[nodiscard]] std::string nuScenesChannel(const std::vector<CameraDescription>& cameras,
                                          std::size_t camera);

/// The name of the lidar's channel.
inline constexpr const char* kNuScenesLidar = "LIDAR_TOP";

/// The nuScenes scene (a sequence of samples) to which a scene belongs: the one of its split and
/// motion.
[[nodiscard]] std::size_t nuScenesSequence(const DatasetInfo& dataset, const Scene& scene);

/// Whether an instant is a sample, with annotations; data between samples are sweeps.
[[nodiscard]] bool isNuScenesKeyframe(const DatasetInfo& dataset, const NuScenesOptions& options,
                                      std::int64_t instant);

/// A placeholder picture for the map, which does not exist.
inline constexpr const char* kNuScenesMap = "maps/empty.png";

}  // namespace synthetic_dataset

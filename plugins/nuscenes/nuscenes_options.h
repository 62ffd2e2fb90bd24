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
  std::optional<std::size_t> lidar;  ///< that is LIDAR_TOP, in DatasetInfo::lidars
  CloudPositions positions = CloudPositions::kAtStamp;  ///< of its points
  bool lidarseg = true;             ///< whether there is a category of each point
  std::int64_t min_points = 0;      ///< objects of which it has fewer are not annotated
  std::int64_t keyframe_every = 1;  ///< which instants of a motion are samples, from its first
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

/// A record's token: 32 digits, which are the same whatever other records there are.
[[nodiscard]] std::string nuScenesToken(NuScenesTable table, std::int64_t first,
                                        std::int64_t second = 0);

/// What a camera is called: CAM_FRONT where it is the only one, else CAM_ and its name.
[[nodiscard]] std::string nuScenesChannel(const std::vector<CameraDescription>& cameras,
                                          std::size_t camera);

/// What the lidar is called.
inline constexpr const char* kNuScenesLidar = "LIDAR_TOP";

/// Which nuScenes scene, which is a sequence of samples, a scene belongs to: its split's and
/// motion's.
[[nodiscard]] std::size_t nuScenesSequence(const DatasetInfo& dataset, const Scene& scene);

/// Whether an instant is a sample, with annotations; what is between them is sweeps.
[[nodiscard]] bool isNuScenesKeyframe(const DatasetInfo& dataset, const NuScenesOptions& options,
                                      std::int64_t instant);

/// The picture that stands for the map, which nobody has.
inline constexpr const char* kNuScenesMap = "maps/empty.png";

}  // namespace synthetic_dataset

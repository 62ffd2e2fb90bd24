#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset {
inline namespace v2 {

/// What one ray of a lidar has measured, and of what. Frame S: the scanner's, x ahead, y left, z
/// up, as REP 103 has it. A recorded point may lie on nothing that the world has: it has no labels
/// then, and no normal.
struct CloudPoint {
  Eigen::Vector3f position_S{0, 0, 0};  ///< as the scanner stands when the ray is sent [m]

  /// The same place as the scanner stands at the scene's stamp [m]: without the bending that its
  /// motion within the sweep causes. What moves in the world is where it was at the point's time.
  Eigen::Vector3f position_at_stamp_S{0, 0, 0};

  Eigen::Vector3f normal_S{0, 0, 0};  ///< of the surface, unit length, towards the scanner; or 0
  float intensity = 0.0F;             ///< 0 nothing .. 1 a white wall that is met at right angles
  std::int32_t time = 0;              ///< since the scene's stamp [ns]
  std::uint32_t column = 0;           ///< its place among those of its ring, below Cloud::columns
  std::uint16_t ring = 0;             ///< which beam, below Cloud::rings

  std::uint16_t instance = 0;      ///< SceneObject::instance of the object; 0 for the world
  std::uint16_t class_number = 0;  ///< as Scene::class_map: from 1; 0 for the world
  std::uint16_t world_class = 0;   ///< as Scene::world_map: from 1; 0 for what is of none
  std::uint16_t part = 0;          ///< as Scene::part_map: from 1; 0 for what is of none
};

/// One sweep of a lidar: the middle of it is at the scene's stamp, or it is the recorded one that
/// is nearest. Rays that measure nothing have no point.
struct Cloud {
  std::size_t lidar = 0;           ///< its index in DatasetInfo::lidars
  Pose X_GS = Pose::Identity();    ///< at the scene's stamp
  int columns = 0;                 ///< times at which rays are sent
  int rings = 0;                   ///< beams
  std::vector<CloudPoint> points;  ///< column by column, in each by ring; or as they were recorded

  /// How many points each object has, in the order of Scene::objects.
  std::vector<std::int64_t> points_of_objects;
};

/// The sweeps of an instant, which all of its scenes share; in the order of DatasetInfo::lidars.
using Clouds = std::vector<std::shared_ptr<const Cloud>>;

}  // namespace v2
}  // namespace synthetic_dataset

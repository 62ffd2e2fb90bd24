#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset {
inline namespace v2 {

/// The return of one lidar ray, with the labels of the surface that it hit. Frame S is the
/// scanner's: x forward, y left, z up (REP 103). A recorded point may lie on no surface of the
/// world; it then has no labels and no normal.
struct CloudPoint {
  Eigen::Vector3f position_S{0, 0, 0};  ///< from the scanner's pose when the ray is sent [m]

  /// The same point from the scanner's pose at the scene's stamp [m]: without the distortion that
  /// the scanner's motion during the sweep causes. Moving objects are where they were at the
  /// point's time.
  Eigen::Vector3f position_at_stamp_S{0, 0, 0};

  Eigen::Vector3f normal_S{0, 0, 0};  ///< of the surface, unit length, towards the scanner; or 0
  float intensity = 0.0F;             ///< 0 (nothing) .. 1 (a white wall at normal incidence)
  std::int32_t time = 0;              ///< relative to the scene's stamp [ns]
  std::uint32_t column = 0;           ///< index within its ring, below Cloud::columns
  std::uint16_t ring = 0;             ///< index of the beam, below Cloud::rings

  std::uint16_t instance = 0;      ///< SceneObject::instance of the object; 0 for the world
  std::uint16_t class_number = 0;  ///< as in Scene::class_map: from 1; 0 for the world
  std::uint16_t world_class = 0;   ///< as in Scene::world_map: from 1; 0 for no class
  std::uint16_t part = 0;          ///< as in Scene::part_map: from 1; 0 for no part
};

/// One lidar sweep: either a simulated one whose middle is at the scene's stamp, or the recorded
/// one nearest to it. Rays without a return have no point.
struct Cloud {
  std::size_t lidar = 0;           ///< its index in DatasetInfo::lidars
  Pose X_GS = Pose::Identity();    ///< at the scene's stamp
  int columns = 0;                 ///< number of firing times
  int rings = 0;                   ///< number of beams
  std::vector<CloudPoint> points;  ///< by column, then by ring; or in recorded order

  /// The number of points on each object, in the order of Scene::objects.
  std::vector<std::int64_t> points_of_objects;
};

/// The sweeps of one instant, shared by all of its scenes; in the order of DatasetInfo::lidars.
using Clouds = std::vector<std::shared_ptr<const Cloud>>;

}  // namespace v2
}  // namespace synthetic_dataset

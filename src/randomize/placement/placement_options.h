#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::randomize {

/// Bullet needs two seconds of stillness before something counts as lying.
constexpr double kShortestFall = 2.5;  // [s]

/// Where objects may be put.
enum class PlacementMode {
  kMap,     ///< on the free places of an occupancy map
  kVolume,  ///< anywhere in a box, in any orientation
  kDrop,    ///< from there, until they have fallen and come to rest
};

/// A box along the axes of the global frame [m].
struct Volume {
  Eigen::Vector3d low{0, 0, 0};
  Eigen::Vector3d high{0, 0, 0};
};

/// What a surface has to be like for a thing to stand on it.
struct SurfaceOptions {
  double highest = 2.0;      ///< what is above it in the global frame counts for nothing [m]
  double steepest = 0.35;    ///< [rad] from the horizontal
  double unevenness = 0.05;  ///< how far below or above the surface's plane it may lie at the
                             ///< corners of what stands on it [m]
};

/// How objects are put somewhere at random, anew for each scene.
struct PlacementOptions {
  PlacementMode mode = PlacementMode::kMap;
  std::optional<std::string> map_file;   ///< map_server's YAML; absolute
  std::optional<std::string> map_topic;  ///< of the bag, or of a running system
  std::optional<Value> received_map;     ///< what that has sent: see received_map.h
  bool on_surface = true;                ///< of kMap: on what is below; else at `height`
  double height = 0.0;                   ///< of the objects' frames in the global frame [m]
  SurfaceOptions surface;                ///< of kMap
  Volume volume;                         ///< of kVolume and kDrop
  bool upright = false;                  ///< of kVolume and kDrop: turned about the vertical alone
  double fall_time = 10.0;               ///< [s] in which what is dropped has to come to rest
  int tries = 1000;                      ///< for each object in each scene
};

}  // namespace synthetic_dataset::randomize

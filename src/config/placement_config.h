#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::config {

/// Bullet needs two seconds of stillness before something counts as lying.
constexpr double kShortestFall = 2.5;  // [s]

/// Where objects may be put.
enum class PlacementMode {
  kMap,     ///< on the free places of an occupancy map
  kVolume,  ///< anywhere in a box, turned anyhow
  kDrop,    ///< from there, until they have fallen and come to rest
};

/// A box along the axes of the global frame [m].
struct Volume {
  Eigen::Vector3d low{0, 0, 0};
  Eigen::Vector3d high{0, 0, 0};
};

/// How objects are put somewhere at random, anew for each scene.
struct PlacementConfig {
  PlacementMode mode = PlacementMode::kMap;
  std::optional<std::string> map_file;   ///< map_server's YAML; absolute
  std::optional<std::string> map_topic;  ///< of the bag, or of a running system
  std::optional<Value> received_map;     ///< what that has sent: see received_map.h
  bool on_surface = true;                ///< of kMap: on what is below; else at `height`
  double height = 0.0;                   ///< of the objects' frames in the global frame [m]
  double highest_surface = 2.0;          ///< what is above it is no place to stand on [m]
  double steepest = 0.35;                ///< [rad] of a surface to stand on
  double unevenness = 0.05;              ///< [m] of a surface below an object's corners
  Volume volume;                         ///< of kVolume and kDrop
  bool upright = false;                  ///< of kVolume and kDrop: turned about the vertical alone
  double fall_time = 10.0;               ///< [s] in which what is dropped has to come to rest
  int tries = 1000;                      ///< for each object in each scene
};

/// Reads a group's `volume: {min: [x, y, z], max: [x, y, z]}`, without which there is an error.
[[nodiscard]] Volume readVolume(Parameters group);

/// Reads the group `placement`. What is wrong is noted there, with a harmless value in its place.
[[nodiscard]] PlacementConfig readPlacement(Parameters root);

}  // namespace synthetic_dataset::config

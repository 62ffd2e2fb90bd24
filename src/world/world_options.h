#pragma once

#include <chrono>
#include <optional>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::world {

/// What to do with a world that names a missing or unreadable file: reject it, or load it without
/// what needs the file.
enum class OnMissingAsset { kError, kWarn };

/// The simulator whose rules a world's colours and lights are meant for (docs/rendering.md).
enum class Simulator {
  kClassic,  ///< Gazebo Classic (OGRE 1): Blinn-Phong on the numbers that the file gives
  kGz,       ///< gz-sim, formerly Ignition Gazebo (ogre2): physically based, in linear light
};

/// Options that the files do not specify.
struct LoadOptions {
  OnMissingAsset on_missing_asset = OnMissingAsset::kError;
  std::optional<Simulator> simulator;  ///< of worlds; none: their files decide
};

struct PhysicsOptions {
  Duration step = std::chrono::microseconds(4000);  ///< fixed step of the simulation; at least 1 us
  double contact_tolerance = 0.01;  ///< [m], >= 0: shallower overlaps are not reported
  bool drops_objects = false;       ///< whether drop() will be called
  bool drops_distractors = false;   ///< whether dropDistractors() will be called
  bool labels_distractors = false;  ///< whether they are numbered as objects, after the others
};

}  // namespace synthetic_dataset::world

#pragma once

#include <chrono>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::world {

struct PhysicsOptions {
  Duration step = std::chrono::microseconds(4000);  ///< of the simulation, fixed; at least 1 us
  double contact_tolerance = 0.01;  ///< [m], >= 0: shallower overlaps are not reported
  bool drops_objects = false;       ///< whether drop() will be called
  bool drops_distractors = false;   ///< whether dropDistractors() will be called
  bool labels_distractors = false;  ///< whether they are numbered as objects, behind the others
};

}  // namespace synthetic_dataset::world

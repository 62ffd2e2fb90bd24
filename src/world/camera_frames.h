#pragma once

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::world {

/// The pose of the optical frame (x right, y down, z forward) in the body frame (x forward, y left,
/// z up), both as defined by REP 103. SDF cameras look along the x axis of their body frame.
[[nodiscard]] inline Pose opticalInBody() {
  Pose X_BC = Pose::Identity();
  X_BC.linear() << 0, 0, 1,  //
      -1, 0, 0,              //
      0, -1, 0;
  return X_BC;
}

}  // namespace synthetic_dataset::world

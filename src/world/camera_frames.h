#pragma once

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::world {

/// The optical frame (x right, y down, z forward) in a body frame (x forward, y left, z up), as REP
/// 103 has both. SDF's cameras look along their body frame's x.
[[nodiscard]] inline Pose opticalInBody() {
  Pose X_BC = Pose::Identity();
  X_BC.linear() << 0, 0, 1,  //
      -1, 0, 0,              //
      0, -1, 0;
  return X_BC;
}

}  // namespace synthetic_dataset::world

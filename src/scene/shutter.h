#pragma once

#include <vector>

#include "scene/camera_options.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::scene {

/// A time at which the poses of everything have to be known.
struct ShotMoment {
  Duration offset{0};  ///< from the picture's stamp
  double row = 0.0;    ///< taken then, from 0; may be between rows or outside the image
};

/// One exposure of the whole picture: all rows at one moment, or one row after the other, from the
/// first moment to the last.
struct Shot {
  std::vector<ShotMoment> moments;  ///< ascending
  double weight = 1.0;              ///< in the picture

  [[nodiscard]] bool rolls() const { return moments.size() > 1; }
};

/// All shots that make up a picture, in the order of their times. A rolling one has a moment at
/// each border of the bands of rows.
/// @param height  of the picture [px]
[[nodiscard]] std::vector<Shot> shotsOf(const Shutter& shutter, int height);

/// The total time, before and after its stamp, over which a picture is exposed.
[[nodiscard]] inline Duration openTime(const Shutter& shutter) {
  return shutter.exposure_time + shutter.readout_time;
}

}  // namespace synthetic_dataset::scene

#pragma once

#include <vector>

#include "scene/camera_options.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::scene {

/// A time at which it has to be known where all is.
struct ShotMoment {
  Duration offset{0};  ///< from the picture's stamp
  double row = 0.0;    ///< that is taken then: from the first one; between rows, or beside all
};

/// One look at the whole picture: all rows at one moment, or one row after the other, from the
/// first moment to the last.
struct Shot {
  std::vector<ShotMoment> moments;  ///< ascending
  double weight = 1.0;              ///< in the picture

  [[nodiscard]] bool rolls() const { return moments.size() > 1; }
};

/// All looks that make up a picture, in the order of their times. One that rolls has a moment at
/// each border of the bands of rows.
/// @param height  of the picture [px]
[[nodiscard]] std::vector<Shot> shotsOf(const Shutter& shutter, int height);

/// How long before and after its stamp a picture is exposed, in all.
[[nodiscard]] inline Duration openTime(const Shutter& shutter) {
  return shutter.exposure_time + shutter.readout_time;
}

}  // namespace synthetic_dataset::scene

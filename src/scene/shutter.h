#pragma once

#include <vector>

#include "scene/camera_options.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::scene {

/// One look at some rows of the picture.
struct Shot {
  Duration offset{0};  ///< from the picture's stamp
  int first_row = 0;
  int row_count = 0;
  double weight = 1.0;  ///< in the average of these rows
};

/// All looks that make up a picture, in the order of their times.
/// @param height  of the picture [px]
[[nodiscard]] std::vector<Shot> shotsOf(const Shutter& shutter, int height);

/// How long before and after its stamp a picture is exposed, in all.
[[nodiscard]] inline Duration openTime(const Shutter& shutter) {
  return shutter.exposure_time + shutter.readout_time;
}

}  // namespace synthetic_dataset::scene

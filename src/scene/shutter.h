#pragma once

#include <vector>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset {

/// When a camera's sensor gathers light. A picture's stamp is the middle of its exposure: of the
/// whole picture's, and with a rolling shutter of its middle row's.
struct Shutter {
  Duration exposure_time{0};  ///< of each row; above 0 what moves is blurred
  int motion_samples = 1;     ///< pictures that are averaged over it
  Duration readout_time{0};   ///< from the first row's exposure to the last row's
  int readout_bands = 1;      ///< rows are taken in so many groups
};

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

}  // namespace synthetic_dataset

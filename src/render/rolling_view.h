#pragma once

#include <vector>

#include <opencv2/core/types.hpp>

#include "render/view.h"
#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::render {

/// Where all is at the time at which a row of a picture is taken.
struct RollingMoment {
  double row = 0.0;  ///< from the picture's first; may lie between rows, or beside the picture
  Pose X_WC = Pose::Identity();
  std::vector<Pose> X_WL;  ///< of each link
};

/// From where a picture is taken whose rows are not all taken at one time.
struct RollingView {
  CameraModel camera;

  /// At least two, in the order of their rows. Between them poses are interpolated.
  std::vector<RollingMoment> moments;

  /// Rows that share the time of their lights and shadows, as bands of equal height.
  int bands = 1;

  /// Where all is when a row is taken. Orientations turn evenly, as tf2 has it.
  [[nodiscard]] RollingMoment at(double row) const;

  /// When the middle row is taken.
  [[nodiscard]] RollingMoment middle() const { return at(0.5 * (camera.height() - 1)); }

  /// The picture's rows of one of the bands.
  [[nodiscard]] cv::Rect rowsOf(int band) const;
};

}  // namespace synthetic_dataset::render

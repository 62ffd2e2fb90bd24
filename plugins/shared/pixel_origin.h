#pragma once

#include "synthetic_dataset/box.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset {

/// Where fractions of an image begin, as formats without a rule of their own are read.
struct PixelOrigin {
  /// From the first pixel's centre to there [px]: 0 for the centre itself, as nn_data_collection
  /// has it; half a pixel for the image's edge, from which Darknet and Ultralytics count.
  double offset = 0.0;

  [[nodiscard]] Box of(const Box& box) const {
    return {box.left + offset, box.top + offset, box.right + offset, box.bottom + offset};
  }

  /// A box that is counted from there, in OpenCV's coordinates again.
  [[nodiscard]] Box back(const Box& box) const {
    return {box.left - offset, box.top - offset, box.right - offset, box.bottom - offset};
  }
};

[[nodiscard]] inline PixelOrigin readPixelOrigin(Parameters& parameters) {
  const bool is_edge =
      parameters.optionalChoice("pixel_origin", {"centre", "edge"}, "centre") == "edge";
  return {is_edge ? 0.5 : 0.0};
}

}  // namespace synthetic_dataset

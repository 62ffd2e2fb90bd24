#pragma once

#include "synthetic_dataset/box.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset {

/// The origin of coordinates given as fractions of an image, for formats that do not define it.
struct PixelOrigin {
  /// Distance from the origin to the first pixel's centre [px]: 0 for the centre itself, as in
  /// nn_data_collection; half a pixel for the image's edge, as in Darknet and Ultralytics.
  double offset = 0.0;

  [[nodiscard]] Box of(const Box& box) const {
    return {box.left + offset, box.top + offset, box.right + offset, box.bottom + offset};
  }

  /// Converts a box relative to the origin back to OpenCV's coordinates.
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

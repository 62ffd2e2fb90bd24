#pragma once

#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/mask.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::label {

/// How well an outline meets the edges of a picture. Of each pair of neighbouring pixels (side by
/// side, or one below the other) of which one is in the mask and the other is not, `met` sums up
/// the contrast between the two, and `most` the highest contrast between such neighbours up to
/// kReach pixels across the outline. Contrast is the difference of blue, green and red, summed up,
/// of the picture smoothed by a Gaussian of 1 pixel.
struct Alignment {
  static constexpr int kReach = 6;  ///< [px]

  double met = 0.0;
  double most = 0.0;

  /// met / most, 0 .. 1: 1 where the outline lies on the highest contrast everywhere; some 0.3
  /// where it has nothing to do with the picture. Nothing without any contrast.
  [[nodiscard]] std::optional<double> score() const {
    if (most <= 0.0) return std::nullopt;
    return met / most;
  }

  Alignment& operator+=(const Alignment& other) {
    met += other.met;
    most += other.most;
    return *this;
  }
};

/// A picture as outlines are held against it: smoothed.
/// @param picture  CV_8UC3
[[nodiscard]] cv::Mat smoothed(const cv::Mat& picture);

/// The alignment of a mask's outline inside the image.
/// @param picture  of smoothed(), of the mask's image's size
[[nodiscard]] Alignment alignmentOf(const Mask& mask, const cv::Mat& picture);

/// The alignment of each object's visible mask, in their order; that of unseen objects is empty.
/// @param scene  with visible masks
/// @param recorded  the picture that was recorded at its time
[[nodiscard]] std::vector<Alignment> alignmentsOf(const Scene& scene, const cv::Mat& recorded);

}  // namespace synthetic_dataset::label

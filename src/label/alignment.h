#pragma once

#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/mask.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::label {

/// How well an outline follows the edges of a picture. For each pair of neighbouring pixels (side
/// by side, or one below the other) of which exactly one is in the mask, `met` sums the contrast
/// between the two, and `most` the highest contrast between such neighbours up to kReach pixels
/// across the outline. The contrast is the sum of the absolute differences of blue, green and red,
/// in the picture smoothed by a Gaussian of 1 pixel.
struct Alignment {
  static constexpr int kReach = 6;  ///< [px]

  double met = 0.0;
  double most = 0.0;

  /// met / most, 0 .. 1: 1 where the outline lies on the highest contrast everywhere; about 0.3
  /// where it is unrelated to the picture. Nothing if there is no contrast at all.
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

/// Smooths a picture, so that outlines can be compared with it.
/// @param picture  CV_8UC3
[[nodiscard]] cv::Mat smoothed(const cv::Mat& picture);

/// The alignment of a mask's outline inside the image.
/// @param picture  from smoothed(), of the size of the mask's image
[[nodiscard]] Alignment alignmentOf(const Mask& mask, const cv::Mat& picture);

/// The alignment of each object's visible mask, in the objects' order; that of unseen objects is
/// empty.
/// @param scene  with visible masks
/// @param recorded  the picture that was recorded at the scene's time
[[nodiscard]] std::vector<Alignment> alignmentsOf(const Scene& scene, const cv::Mat& recorded);

}  // namespace synthetic_dataset::label

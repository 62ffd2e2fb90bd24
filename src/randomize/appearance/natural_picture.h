#pragma once

#include <string>

#include <opencv2/core/mat.hpp>

#include "base/random/random_source.h"

namespace synthetic_dataset::randomize {

/// A synthesized picture with the statistics of photographs: edges of all sizes, and the materials
/// and colours of everyday surroundings.
struct NaturalPicture {
  std::string kind;  ///< "brick", "street"
  cv::Mat pixels;    ///< CV_8UC4, blue green red alpha, opaque
};

/// Draws a surface of one material that tiles seamlessly.
/// @param side  256 or 512 [px]
[[nodiscard]] NaturalPicture drawNaturalTexture(base::RandomSource& random, int side);

/// Draws a background: a street, a room, clutter, and so on.
/// @param width, height  at least 64 [px]
[[nodiscard]] NaturalPicture drawNaturalPicture(base::RandomSource& random, int width, int height);

}  // namespace synthetic_dataset::randomize

#pragma once

#include <string>

#include <opencv2/core/mat.hpp>

#include "base/random/random_source.h"

namespace synthetic_dataset::randomize {

/// A picture that is made up, with the statistics of photographs: edges of all sizes, the materials
/// and the colours of what is around us.
struct NaturalPicture {
  std::string kind;  ///< "brick", "street"
  cv::Mat pixels;    ///< CV_8UC4, blue green red alpha, opaque
};

/// A surface of one material, which repeats without a seam.
/// @param side  256 or 512 [px]
[[nodiscard]] NaturalPicture drawNaturalTexture(base::RandomSource& random, int side);

/// What is behind things: a street, a room, clutter, and so on.
/// @param width, height  at least 64 [px]
[[nodiscard]] NaturalPicture drawNaturalPicture(base::RandomSource& random, int width, int height);

}  // namespace synthetic_dataset::randomize

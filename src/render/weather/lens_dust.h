#pragma once

#include <cstdint>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/camera_model.h"

namespace synthetic_dataset::render {

/// Dust on the glass in front of a lens.
struct LensDust {
  double share = 0.0;      ///< of the glass that is covered, 0 .. 0.2
  std::uint64_t seed = 0;  ///< of its specks
};

/// A picture as seen through dusty glass, 2 cm in front of the lens's aperture of 2 mm. The light
/// of a pixel passes through a part of the glass that is as wide as the aperture: a speck thus
/// takes its share of the light from all pixels of a disc, the image of the aperture's width at the
/// glass's distance. Specks are 0.1 to 1 mm wide; they scatter half of the picture's mean light
/// into the lens from all directions, so that they dim what is bright and veil what is dark.
///
/// A speck has its place on the glass: a larger share adds other specks, and other focal lengths
/// see the same ones. In front of a lens that sees more than 180 degrees, the glass is a dome.
/// @param picture  CV_8UC3, sRGB-encoded
[[nodiscard]] cv::Mat throughDust(const cv::Mat& picture, const CameraModel& camera,
                                  const LensDust& dust);

}  // namespace synthetic_dataset::render

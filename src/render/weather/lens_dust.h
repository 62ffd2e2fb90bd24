#pragma once

#include <cstdint>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/camera_model.h"

namespace synthetic_dataset::render {

/// Dust on the glass before a lens.
struct LensDust {
  double share = 0.0;      ///< of the glass that it covers, 0 .. 0.2
  std::uint64_t seed = 0;  ///< of its specks
};

/// A picture as it looks through a glass with dust, 2 cm before the lens's aperture of 2 mm. What a
/// pixel sees comes through a part of the glass that is as wide as the aperture: so a speck takes
/// its share of the light from all pixels of a disc, which is that wide at that distance. Specks
/// are 0.1 to 1 mm wide; on average, half of the light that the picture shows falls through them
/// into all directions, so that they dim what is bright and veil what is dark.
///
/// A speck has its place on the glass: a larger share adds others, and other focal lengths see the
/// same ones. The glass before a lens of more than half the world is a dome.
/// @param picture  CV_8UC3, sRGB-encoded
[[nodiscard]] cv::Mat throughDust(const cv::Mat& picture, const CameraModel& camera,
                                  const LensDust& dust);

}  // namespace synthetic_dataset::render

#pragma once

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/camera_model.h"

namespace synthetic_dataset::render {

/// The surfaces that may occlude one another's ambient light, as seen by the pixels.
struct Occluders {
  cv::Mat depth;   ///< CV_32FC1: as in GeometryImages; 0 where there is nothing
  cv::Rect place;  ///< of these pixels in the picture
  cv::Size image;  ///< the picture's size
  Intrinsics intrinsics;
  cv::Mat rays = {};  ///< as in SeenSurfaces; empty for a pinhole camera
};

/// Up to how many pixels away what is seen affects a surface's light.
[[nodiscard]] int occlusionReach(const cv::Size& image);

/// For each pixel, the distance beyond which what is seen does not affect it.
/// @return CV_32FC1, for the pixels of `seen` [px]
[[nodiscard]] cv::Mat occlusionReaches(const Occluders& seen);

/// The share of ambient light that reaches surfaces past what is within 0.4 m of them: from 0,
/// none, to 1. Computed from what the picture shows, by horizons in sixteen planes (Jimenez, Wu,
/// Pesce and Jarabo 2016, "Practical Realtime Strategies for Accurate Indirect Occlusion"): each
/// pixel of a 4 x 4 square takes one plane, and all pixels of the square share the results.
/// @param seen  includes the pixels up to at least occlusionReach() around the wanted ones
/// @param normals  CV_16UC4 of `place`: as in GeometryImages, of the wanted pixels and
///     kOcclusionSmoothing more around them
/// @param place  of the result in the picture
/// @param wanted  CV_8UC1 of `place`: not 0 for the pixels to compute; the result is undefined for
///     all others
/// @return CV_32FC1 of `place`
[[nodiscard]] cv::Mat ambientVisibility(const Occluders& seen, const cv::Mat& normals,
                                        const cv::Rect& place, const cv::Mat& wanted);

/// The number of pixels around the wanted ones for which ambientVisibility() needs normals.
inline constexpr int kOcclusionSmoothing = 2;

}  // namespace synthetic_dataset::render

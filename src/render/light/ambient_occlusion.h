#pragma once

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/camera_model.h"

namespace synthetic_dataset::render {

/// What surfaces may hide one another from the light that is everywhere, as pixels see them.
struct Occluders {
  cv::Mat depth;   ///< CV_32FC1: as of GeometryImages; 0 where nothing is
  cv::Rect place;  ///< of these pixels in the picture
  cv::Size image;  ///< the picture's size
  Intrinsics intrinsics;
  cv::Mat rays = {};  ///< as of SeenSurfaces; empty for those of a pinhole
};

/// How many pixels away what is seen affects a surface's light.
[[nodiscard]] int occlusionReach(const cv::Size& image);

/// The same of single pixels: what is seen farther away has no part in them.
/// @return CV_32FC1 of the pixels of `seen` [px]
[[nodiscard]] cv::Mat occlusionReaches(const Occluders& seen);

/// Which share of the light that is everywhere reaches surfaces past what is within 0.4 m of them:
/// from 0, none, to 1. Found from what the picture shows, by horizons in sixteen planes (Jimenez,
/// Wu, Pesce and Jarabo 2016, "Practical Realtime Strategies for Accurate Indirect Occlusion"), of
/// which each pixel of a 4 x 4 square takes one, and all share what they find.
/// @param seen  the pixels at least up to occlusionReach() around those that are wanted
/// @param normals  CV_16UC4 of `place`: as of GeometryImages, of the wanted pixels and
///     kOcclusionSmoothing more around them
/// @param place  of the result in the picture
/// @param wanted  CV_8UC1 of `place`: not 0 for the pixels to compute; the result is undefined for
///     all others
/// @return CV_32FC1 of `place`
[[nodiscard]] cv::Mat openness(const Occluders& seen, const cv::Mat& normals, const cv::Rect& place,
                               const cv::Mat& wanted);

/// How many pixels around the wanted ones openness() needs normals of.
inline constexpr int kOcclusionSmoothing = 2;

}  // namespace synthetic_dataset::render

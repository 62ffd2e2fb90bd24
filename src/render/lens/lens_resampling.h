#pragma once

#include <opencv2/core/mat.hpp>

#include "render/lens/lens_map.h"

namespace synthetic_dataset::render {

/// The part of a face at which the pixels of a region look, with room for filters; empty where none
/// of them looks at it.
[[nodiscard]] cv::Rect neededOf(const LensMap& map, std::size_t face, const cv::Rect& region);

/// Puts the pixels of a region that look at a face into the picture: the mean light of what each of
/// them covers.
/// @param drawn  the face's picture; sRGB-encoded, as is `picture` (both CV_8UC3)
void resampleSmooth(const LensMap& map, std::size_t face, const cv::Mat& drawn,
                    const cv::Rect& region, cv::Mat& picture);

/// The same, with the face's pixel that is nearest to each pixel's centre.
void resampleCentres(const LensMap& map, std::size_t face, const cv::Mat& drawn,
                     const cv::Rect& region, cv::Mat& picture);

}  // namespace synthetic_dataset::render

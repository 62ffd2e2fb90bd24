#pragma once

#include <opencv2/core/mat.hpp>

#include "render/lens/lens_map.h"

namespace synthetic_dataset::render {

/// The part of a face at which the pixels of a region look, with a margin for filters; empty if
/// none of them looks at the face.
[[nodiscard]] cv::Rect neededOf(const LensMap& map, std::size_t face, const cv::Rect& region);

/// Fills in those pixels of a region that look at a face: each with the mean light of the area that
/// it covers.
/// @param drawn  the face's picture; sRGB-encoded, as is `picture` (both CV_8UC3)
void resampleSmooth(const LensMap& map, std::size_t face, const cv::Mat& drawn,
                    const cv::Rect& region, cv::Mat& picture);

/// Like resampleSmooth(), but takes the face's pixel that is nearest to each pixel's centre.
void resampleCentres(const LensMap& map, std::size_t face, const cv::Mat& drawn,
                     const cv::Rect& region, cv::Mat& picture);

}  // namespace synthetic_dataset::render

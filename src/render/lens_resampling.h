#pragma once

#include <optional>

#include <opencv2/core/mat.hpp>

#include "render/lens_map.h"
#include "render/render_target.h"

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

/// Puts a face's labels into those of the picture, from the same places as resampleCentres. Depth
/// becomes z in the lens's frame, at the pixel's centre where the surface is flat about it.
void resampleLabels(const LensMap& map, std::size_t face, const LabelImages& drawn,
                    LabelImages& labels);

}  // namespace synthetic_dataset::render

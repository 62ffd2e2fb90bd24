#pragma once

#include <optional>

#include <opencv2/core/mat.hpp>

#include "render/gl/render_target.h"
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

/// Puts a part of a face's mask into the picture's, from the same places as resampleCentres.
/// @param drawn  the part `needed` of the face, which neededOf gave for the region
/// @param mask  CV_8UC1 of the region's size
void resampleMask(const LensMap& map, std::size_t face, const cv::Mat& drawn,
                  const cv::Rect& needed, const cv::Rect& region, cv::Mat& mask);

/// Puts a face's labels, which have slopes, into those of the picture, from the same places as
/// resampleCentres. Depth becomes z in the lens's frame, where the pixel's ray meets the plane of
/// the triangle seen there. Of links, normals and range, those are made that `labels` has room for.
void resampleLabels(const LensMap& map, std::size_t face, const LabelImages& drawn,
                    LabelImages& labels);

}  // namespace synthetic_dataset::render

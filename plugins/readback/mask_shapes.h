#pragma once

#include <vector>

#include <nlohmann/json.hpp>
#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/mask.h"

/// Masks of the shapes that files describe, to be held against the true ones.
namespace synthetic_dataset::formats {

/// The pixels that polygons along pixels' edges enclose, in coordinates in which the image spans 0
/// to its width: CV_8UC1, 255 on them.
/// @param polygons  lists of x, y, x, y, ...
/// @throws Error where an edge is no line between pixels, along a row or a column, or where
/// polygons
///     overlap
[[nodiscard]] cv::Mat maskOfEdges(const nlohmann::json& polygons, const cv::Size& size);

/// What is wrong with a polygon of pixels' centres that should be a mask: empty for nothing. Filled
/// with its rim, it has all pixels of the mask; others are on lines between the mask's parts alone,
/// where it has several.
[[nodiscard]] std::string outlineProblem(const std::vector<cv::Point>& outline, const Mask& mask);

/// The same of a list of [x, y].
[[nodiscard]] std::string outlineProblem(const nlohmann::json& points, const Mask& mask);

}  // namespace synthetic_dataset::formats

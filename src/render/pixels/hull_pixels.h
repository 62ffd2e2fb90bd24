#pragma once

#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "render/view.h"

namespace synthetic_dataset::render {

/// A rectangle of the pixels on which the convex hull of points in the world may be seen, with a
/// small margin.
/// @param view  without distortion
[[nodiscard]] cv::Rect pixelsOfHull(const std::vector<Eigen::Vector3d>& points_W, const View& view);

/// Sets the pixels on which such a hull may be seen, with a small margin, to 255. These are fewer
/// than pixelsOfHull() if the hull is not a rectangle in the picture.
/// @param pixels  CV_8UC1, of the view's size
void markHull(const std::vector<Eigen::Vector3d>& points_W, const View& view, cv::Mat& pixels);

}  // namespace synthetic_dataset::render

#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::test {

/// A box that a camera looks at.
struct SeenBox {
  Pose X_CB = Pose::Identity();  ///< of its centre
  Eigen::Vector3d size = Eigen::Vector3d::Ones();
  int id = 0;
};

/// Boxes as seen at each pixel's centre.
struct BoxView {
  cv::Mat ids;    ///< CV_32SC1
  cv::Mat links;  ///< CV_32SC1: the box's index, counted from 1; 0 for none
  cv::Mat depth;  ///< CV_32FC1
  cv::Mat range;  ///< CV_32FC1
};

/// The distance along a ray from the camera to the box (slab method); infinity if it misses.
[[nodiscard]] inline double distanceTo(const SeenBox& box, const Eigen::Vector3d& ray_C) {
  const Pose X_BC = box.X_CB.inverse();
  double from = 0.0;
  double to = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double start = X_BC.translation()[axis];
    const double direction = X_BC.linear().row(axis).dot(ray_C);
    const double a = (-0.5 * box.size[axis] - start) / direction;
    const double b = (0.5 * box.size[axis] - start) / direction;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from < to && from > 0.0 ? from : std::numeric_limits<double>::infinity();
}

[[nodiscard]] inline BoxView look(const CameraModel& camera, const std::vector<SeenBox>& boxes) {
  const cv::Size size(camera.width(), camera.height());
  BoxView view{cv::Mat::zeros(size, CV_32SC1), cv::Mat::zeros(size, CV_32SC1),
               cv::Mat::zeros(size, CV_32FC1), cv::Mat::zeros(size, CV_32FC1)};
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      const auto ray_C = camera.ray({u, v});
      if (!ray_C) continue;
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        const double distance = distanceTo(boxes[i], *ray_C);
        if (!(distance < nearest)) continue;
        nearest = distance;
        view.ids.at<int>(v, u) = boxes[i].id;
        view.links.at<int>(v, u) = static_cast<int>(i) + 1;
        view.depth.at<float>(v, u) = static_cast<float>(distance * ray_C->z());
        view.range.at<float>(v, u) = static_cast<float>(distance);
      }
    }
  }
  return view;
}

}  // namespace synthetic_dataset::test

#include "label/optical_flow.h"

#include <limits>

#include <opencv2/core/utility.hpp>

namespace synthetic_dataset::label {
namespace {

/// What takes a point of each link from its place in the camera's frame to its next one there.
std::vector<Pose> motions(const Pose& X_WC, const std::vector<Pose>& X_WL, const Pose& X_WC_next,
                          const std::vector<Pose>& X_WL_next) {
  const Pose X_CW_next = X_WC_next.inverse();
  std::vector<Pose> result;
  result.reserve(X_WL.size());
  for (std::size_t i = 0; i < X_WL.size(); ++i) {
    result.emplace_back(X_CW_next * X_WL_next.at(i) * X_WL[i].inverse() * X_WC);
  }
  return result;
}

}  // namespace

cv::Mat opticalFlow(const CameraModel& camera, const cv::Mat& depth, const cv::Mat& range,
                    const cv::Mat& links, const Pose& X_WC, const std::vector<Pose>& X_WL,
                    const CameraModel& camera_next, const Pose& X_WC_next,
                    const std::vector<Pose>& X_WL_next) {
  const std::vector<Pose> motion = motions(X_WC, X_WL, X_WC_next, X_WL_next);
  constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();
  cv::Mat flow(depth.size(), CV_32FC2, cv::Scalar::all(static_cast<double>(kNowhere)));
  const auto move = [&](int v, int u) {
    const int link = links.at<int>(v, u);
    if (link == 0) return;
    const Eigen::Vector2d from(u, v);
    const auto ray_C = camera.ray(from);
    if (!ray_C) return;
    const double distance = range.empty() ? static_cast<double>(depth.at<float>(v, u)) / ray_C->z()
                                          : static_cast<double>(range.at<float>(v, u));
    const Eigen::Vector3d p_C = distance * *ray_C;
    const auto to = camera_next.project(motion.at(static_cast<std::size_t>(link - 1)) * p_C);
    if (!to) return;
    const Eigen::Vector2f step = (*to - from).cast<float>();
    flow.at<cv::Vec2f>(v, u) = {step.x(), step.y()};
  };
  // Rows are worked on side by side; no two calls share a pixel.
  cv::parallel_for_(cv::Range(0, depth.rows), [&](const cv::Range& rows) {
    for (int v = rows.start; v < rows.end; ++v) {
      for (int u = 0; u < depth.cols; ++u) move(v, u);
    }
  });
  return flow;
}

}  // namespace synthetic_dataset::label

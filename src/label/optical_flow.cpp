#include "label/optical_flow.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>

#include <opencv2/core/utility.hpp>

#include "label/row_labels.h"

namespace synthetic_dataset::label {
namespace {

/// For each link, the transform that takes a point of it from its position in the camera's frame to
/// its next position there.
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

constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();

/// @param move  finds where a pixel moves to, if anywhere; is called in several threads
cv::Mat flowOf(const cv::Size& size,
               const std::function<std::optional<Eigen::Vector2d>(int v, int u)>& move) {
  cv::Mat flow(size, CV_32FC2, cv::Scalar::all(static_cast<double>(kNowhere)));
  // Rows are processed in parallel; no two calls share a pixel.
  cv::parallel_for_(cv::Range(0, size.height), [&](const cv::Range& rows) {
    for (int v = rows.start; v < rows.end; ++v) {
      for (int u = 0; u < size.width; ++u) {
        const auto to = move(v, u);
        if (!to) continue;
        const Eigen::Vector2f step = (*to - Eigen::Vector2d(u, v)).cast<float>();
        flow.at<cv::Vec2f>(v, u) = {step.x(), step.y()};
      }
    }
  });
  return flow;
}

}  // namespace

cv::Mat opticalFlow(const CameraModel& camera, const cv::Mat& depth, const cv::Mat& range,
                    const cv::Mat& links, const Pose& X_WC, const std::vector<Pose>& X_WL,
                    const CameraModel& camera_next, const Pose& X_WC_next,
                    const std::vector<Pose>& X_WL_next) {
  const std::vector<Pose> motion = motions(X_WC, X_WL, X_WC_next, X_WL_next);
  return flowOf(depth.size(), [&](int v, int u) -> std::optional<Eigen::Vector2d> {
    const int link = links.at<int>(v, u);
    if (link == 0) return std::nullopt;
    const auto ray_C = camera.ray(Eigen::Vector2d(u, v));
    if (!ray_C) return std::nullopt;
    const double distance = range.empty() ? static_cast<double>(depth.at<float>(v, u)) / ray_C->z()
                                          : static_cast<double>(range.at<float>(v, u));
    const Eigen::Vector3d p_C = distance * *ray_C;
    return camera_next.project(motion.at(static_cast<std::size_t>(link - 1)) * p_C);
  });
}

cv::Mat opticalFlow(const render::RollingView& rows, const cv::Mat& range, const cv::Mat& links,
                    const render::RollingView& next) {
  std::vector<bool> seen(next.moments.front().X_WL.size());
  for (int v = 0; v < links.rows; ++v) {
    const int* row = links.ptr<int>(v);
    for (int u = 0; u < links.cols; ++u) {
      if (row[u] != 0) seen.at(static_cast<std::size_t>(row[u] - 1)) = true;
    }
  }
  const RowFinder finder(next, seen);
  return flowOf(range.size(), [&](int v, int u) -> std::optional<Eigen::Vector2d> {
    if (links.at<int>(v, u) == 0) return std::nullopt;
    const auto link = static_cast<std::size_t>(links.at<int>(v, u) - 1);
    const auto ray_C = rows.camera.ray(Eigen::Vector2d(u, v));
    if (!ray_C) return std::nullopt;
    const Eigen::Vector3d p_C = static_cast<double>(range.at<float>(v, u)) * *ray_C;
    const auto to = finder.find(link, rows.X_CL(link, v).inverse() * p_C);
    return to ? std::optional(to->pixel) : std::nullopt;
  });
}

}  // namespace synthetic_dataset::label

#pragma once

#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/pose.h"

/// Surfaces that were measured by another sensor, as a camera sees them: CV_32FC1 of its image's
/// size, each pixel with the distance from the camera's centre [m] to the nearest surface along its
/// ray, 0 where nothing was measured.
namespace synthetic_dataset::scene {

/// A depth camera with precomputed rays, as computing these takes long for some lenses.
class DepthLens {
 public:
  explicit DepthLens(const CameraModel& camera);

  [[nodiscard]] const CameraModel& camera() const { return camera_; }

  /// Each pixel's ray at depth 1, row by row; z is 0 where the lens has no ray with a positive
  /// depth.
  [[nodiscard]] const std::vector<Eigen::Vector3d>& rays() const { return rays_; }

 private:
  CameraModel camera_;
  std::vector<Eigen::Vector3d> rays_;
};

/// Draws a depth image. Each of its pixels covers the area that it has in the camera's image, so
/// that surfaces have no holes whatever the sizes of the two images.
/// @param depth  CV_32FC1 of the lens's size: z [m], 0 where nothing was measured
/// @param X_CD  of the depth camera in the camera's frame
[[nodiscard]] cv::Mat rangesOfDepth(const cv::Mat& depth, const DepthLens& lens, const Pose& X_CD,
                                    const CameraModel& camera);

/// Draws a cloud. Each point is a rectangle that reaches half-way to its neighbours on all four
/// sides, but not much farther than half of the cloud's usual spacing (the median, horizontally and
/// vertically), and just that far if there is no neighbour. So surfaces close, but holes stay open.
/// @param points_C  [m]
[[nodiscard]] cv::Mat rangesOfCloud(const std::vector<Eigen::Vector3d>& points_C,
                                    const CameraModel& camera);

/// The nearer of both, pixel by pixel.
/// @param first, second  of one size; an empty one counts as nothing
[[nodiscard]] cv::Mat nearestOf(const cv::Mat& first, const cv::Mat& second);

}  // namespace synthetic_dataset::scene

#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/box.h"

namespace synthetic_dataset {
inline namespace v1 {

/// A pinhole camera's inner geometry [px]: u = fx * x / z + cx, v = fy * y / z + cy.
struct Intrinsics {
  double fx = 0.0;
  double fy = 0.0;
  double cx = 0.0;
  double cy = 0.0;
};

/// How points of the optical frame (x right, y down, z forward; metres) fall on the image.
///
/// A pixel's centre has whole coordinates, as with cv::projectPoints: the image spans
/// (-0.5, -0.5) to (width - 0.5, height - 0.5).
class CameraModel {
 public:
  /// @param width, height  of the image [px], at least 1
  /// @param near, far  the range of z that the camera sees [m], 0 < near < far
  /// @throws Error where a value is out of its range
  CameraModel(int width, int height, const Intrinsics& intrinsics, double near, double far);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] const Intrinsics& intrinsics() const { return intrinsics_; }
  [[nodiscard]] double near() const { return near_; }
  [[nodiscard]] double far() const { return far_; }

  /// Where a point of the optical frame falls [px], inside the image or not.
  /// Nothing for a point nearer than the near plane, or behind the camera.
  [[nodiscard]] std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& p_C) const;

  /// The box round the projection of the points' convex hull, which is clipped at the near plane
  /// but not at the image's edge. Nothing when all of it is behind the near plane.
  [[nodiscard]] std::optional<Box> projectedBounds(
      const std::vector<Eigen::Vector3d>& points_C) const;

  /// The image as a box: (-0.5, -0.5) to (width - 0.5, height - 0.5).
  [[nodiscard]] Box imageBounds() const;

 private:
  int width_;
  int height_;
  Intrinsics intrinsics_;
  double near_;
  double far_;
};

}  // namespace v1
}  // namespace synthetic_dataset

#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/box.h"
#include "synthetic_dataset/distortion.h"

namespace synthetic_dataset {
inline namespace v2 {

/// A pinhole camera's inner geometry [px]: u = fx * x / z + cx, v = fy * y / z + cy.
struct Intrinsics {
  double fx = 0.0;
  double fy = 0.0;
  double cx = 0.0;
  double cy = 0.0;
};

[[nodiscard]] inline bool operator==(const Intrinsics& a, const Intrinsics& b) {
  return a.fx == b.fx && a.fy == b.fy && a.cx == b.cx && a.cy == b.cy;
}

/// How points of the optical frame (x right, y down, z forward; metres) fall on the image.
///
/// A pixel's centre has whole coordinates, as with cv::projectPoints: the image spans
/// (-0.5, -0.5) to (width - 0.5, height - 0.5).
///
/// A lens sees no farther from its axis than its distortion is one to one: points beyond have no
/// place on the image, where the formulas alone would fold them back into it. Lenses without a near
/// plane (equidistant, omnidirectional, double sphere) can see past 90 degrees, where z is
/// negative.
class CameraModel {
 public:
  /// @param width, height  of the image [px], at least 1
  /// @param near, far  the range that the camera sees [m], 0 < near < far: of z, with a lens that
  ///     has no near plane of the distance
  /// @throws Error where a value is out of its range
  CameraModel(int width, int height, const Intrinsics& intrinsics, double near, double far,
              const Distortion& distortion = {});

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] const Intrinsics& intrinsics() const { return intrinsics_; }
  [[nodiscard]] const Distortion& distortion() const { return distortion_; }
  [[nodiscard]] double near() const { return near_; }
  [[nodiscard]] double far() const { return far_; }

  /// Where a point of the optical frame falls [px], inside the image or not.
  /// Nothing for a point nearer than `near`, behind the camera or beyond what the lens sees.
  [[nodiscard]] std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& p_C) const;

  /// The unit vector along which the camera sees a place of the image [px].
  /// Nothing where the lens sees nothing (the corners of a fisheye's image).
  [[nodiscard]] std::optional<Eigen::Vector3d> ray(const Eigen::Vector2d& pixel) const;

  /// Whether the intrinsics alone describe the image: there is no distortion, or none that bends
  /// anything.
  [[nodiscard]] bool isPinhole() const;

  /// Whether `near` is a z, and nothing is seen from 90 degrees on; otherwise it is a distance.
  [[nodiscard]] bool hasNearPlane() const;

  /// How far from the principal point what is at an angle from the axis [rad] appears, in focal
  /// lengths: for the lens's kind alone, without the polynomials that bend its picture. Nothing
  /// where such a lens does not see.
  [[nodiscard]] std::optional<double> radiusAt(double angle) const;

  /// The angle [rad] to which radiusAt() gives this or, where it never does, the nearest to it.
  [[nodiscard]] double angleAt(double radius) const;

  /// How far from its axis the lens sees [rad]: up to pi / 2 with a near plane, up to pi without.
  [[nodiscard]] double largestAngle() const { return largest_angle_; }

  /// The box around the projection of the points' convex hull, which is clipped at the near plane
  /// and at the lens's largest angle but not at the image's edge. Nothing when none of it is left.
  /// Of a lens without a near plane the box is that of the hull down to the camera, unless all of
  /// the hull is nearer than `near`. Edges bend with distortion; the box holds them to
  /// 0.05 px.
  [[nodiscard]] std::optional<Box> projectedBounds(
      const std::vector<Eigen::Vector3d>& points_C) const;

  /// The image as a box: (-0.5, -0.5) to (width - 0.5, height - 0.5).
  [[nodiscard]] Box imageBounds() const;

 private:
  int width_;
  int height_;
  Intrinsics intrinsics_;
  Distortion distortion_;
  double near_;
  double far_;
  double largest_angle_;
};

}  // namespace v2
}  // namespace synthetic_dataset

#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/box.h"
#include "synthetic_dataset/distortion.h"

namespace synthetic_dataset {
inline namespace v2 {

/// The intrinsics of a pinhole camera [px]: u = fx * x / z + cx, v = fy * y / z + cy.
struct Intrinsics {
  double fx = 0.0;
  double fy = 0.0;
  double cx = 0.0;
  double cy = 0.0;
};

[[nodiscard]] inline bool operator==(const Intrinsics& a, const Intrinsics& b) {
  return a.fx == b.fx && a.fy == b.fy && a.cx == b.cx && a.cy == b.cy;
}

/// The projection of points in the optical frame (x right, y down, z forward; metres) to the image.
///
/// A pixel's centre has whole coordinates, as with cv::projectPoints: the image spans
/// (-0.5, -0.5) to (width - 0.5, height - 0.5).
///
/// A lens sees only as far from its axis as its distortion is one-to-one: points beyond that have
/// no pixel, although the bare formulas would fold them back into the image. Lenses without a near
/// plane (equidistant, omnidirectional, double sphere) can see past 90 degrees, where z is
/// negative.
class CameraModel {
 public:
  /// @param width, height  of the image [px], at least 1
  /// @param near, far  the visible range [m], 0 < near < far: of z or, for a lens without a near
  ///     plane, of the distance
  /// @throws Error if a value is out of its range
  CameraModel(int width, int height, const Intrinsics& intrinsics, double near, double far,
              const Distortion& distortion = {});

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] const Intrinsics& intrinsics() const { return intrinsics_; }
  [[nodiscard]] const Distortion& distortion() const { return distortion_; }
  [[nodiscard]] double near() const { return near_; }
  [[nodiscard]] double far() const { return far_; }

  /// Projects a point of the optical frame [px]; the result may lie outside the image.
  /// Returns nullopt for a point nearer than `near`, behind the camera or beyond what the lens
  /// sees.
  [[nodiscard]] std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& p_C) const;

  /// The viewing ray through a point of the image [px], as a unit vector in the optical frame.
  /// Returns nullopt where the lens sees nothing (in the corners of a fisheye image).
  [[nodiscard]] std::optional<Eigen::Vector3d> ray(const Eigen::Vector2d& pixel) const;

  /// Whether the intrinsics alone describe the projection: there is no distortion, or it has no
  /// effect.
  [[nodiscard]] bool isPinhole() const;

  /// Whether `near` is a z coordinate and nothing is visible at 90 degrees or more from the axis;
  /// otherwise `near` is a distance.
  [[nodiscard]] bool hasNearPlane() const;

  /// The distance from the principal point, in focal lengths, at which a point at this angle from
  /// the axis [rad] appears. Covers only the lens's base projection, without the distortion
  /// polynomials. Returns nullopt if such a lens does not see that far.
  [[nodiscard]] std::optional<double> radiusAt(double angle) const;

  /// The angle [rad] at which radiusAt() returns this radius or, if it never does, comes nearest.
  [[nodiscard]] double angleAt(double radius) const;

  /// The largest angle from the axis at which the lens sees [rad]: up to pi / 2 with a near plane,
  /// up to pi without.
  [[nodiscard]] double largestAngle() const { return largest_angle_; }

  /// The bounding box of the projection of the points' convex hull. The hull is clipped at the near
  /// plane and at the lens's largest angle but not at the image's edge; returns nullopt if nothing
  /// of it is left. With a lens without a near plane the hull is not clipped at `near`; the result
  /// is nullopt only if all of it is nearer than that. Edges curve with distortion; the box
  /// contains them to 0.05 px.
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

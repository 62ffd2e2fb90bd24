#include "synthetic_dataset/camera_model.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "api/curved_bounds.h"
#include "api/lens.h"
#include "api/lens_model.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {
inline namespace v2 {
namespace {

constexpr double kHalfPi = 1.57079632679489661923;
constexpr int kLargestImage = 16384;  // OpenGL's and PNG readers' common limit for one side [px]

void checkDistortion(const Distortion& distortion) {
  const auto& k = distortion.coefficients;
  if (!std::all_of(k.begin(), k.end(), [](double number) { return std::isfinite(number); })) {
    throw Error("distortion: all coefficients should be finite numbers");
  }
  const lens::LensModel& model = lens::modelOf(distortion.model);
  const std::string fault = model.fault != nullptr ? model.fault(distortion) : "";
  if (!fault.empty()) throw Error("distortion: " + fault);
  if (!(distortion.cutoff_angle > 0.0 && distortion.cutoff_angle <= 3.1415926536)) {
    throw Error("distortion: found a cutoff angle of " + fixed(distortion.cutoff_angle, 3) +
                " rad; it should be above 0 and at most pi");
  }
}

void expand(std::optional<Box>& box, const Eigen::Vector2d& point) {
  if (!box) {
    box = Box{point.x(), point.y(), point.x(), point.y()};
    return;
  }
  box->left = std::min(box->left, point.x());
  box->top = std::min(box->top, point.y());
  box->right = std::max(box->right, point.x());
  box->bottom = std::max(box->bottom, point.y());
}

/// Points whose hull is the part of the hull of `points` at or beyond the near plane.
std::vector<Eigen::Vector3d> clippedCorners(const std::vector<Eigen::Vector3d>& points,
                                            double near) {
  std::vector<Eigen::Vector3d> corners;
  std::vector<const Eigen::Vector3d*> behind;
  for (const Eigen::Vector3d& point : points) {
    if (point.z() >= near) {
      corners.push_back(point);
    } else {
      behind.push_back(&point);
    }
  }
  // The hull's edges that cross the near plane are among the segments between a point in front and
  // one behind; the other segments run inside the hull, so their crossings do not widen it.
  const std::size_t in_front = corners.size();
  for (std::size_t i = 0; i < in_front; ++i) {
    for (const Eigen::Vector3d* b : behind) {
      const Eigen::Vector3d a = corners[i];
      const double share = (near - a.z()) / (b->z() - a.z());
      Eigen::Vector3d crossing = a + share * (*b - a);
      crossing.z() = near;
      corners.push_back(crossing);
    }
  }
  return corners;
}

/// Whether straight lines appear straight, out to the image's farthest corner.
bool isStraight(const Distortion& distortion) {
  return distortion.model == DistortionModel::kNone && distortion.cutoff_angle >= kHalfPi;
}

}  // namespace

CameraModel::CameraModel(int width, int height, const Intrinsics& intrinsics, double near,
                         double far, const Distortion& distortion)
    : width_(width),
      height_(height),
      intrinsics_(intrinsics),
      distortion_(distortion),
      near_(near),
      far_(far),
      largest_angle_(0.0) {
  if (width < 1 || height < 1 || width > kLargestImage || height > kLargestImage) {
    throw Error("image size: found " + std::to_string(width) + " x " + std::to_string(height) +
                " px; each side should be 1 to " + std::to_string(kLargestImage));
  }
  const auto positive = [](double number) { return std::isfinite(number) && number > 0.0; };
  if (!positive(intrinsics.fx) || !positive(intrinsics.fy)) {
    throw Error("focal lengths: found fx " + fixed(intrinsics.fx, 3) + ", fy " +
                fixed(intrinsics.fy, 3) + "; both should be above 0 px");
  }
  if (!std::isfinite(intrinsics.cx) || !std::isfinite(intrinsics.cy)) {
    throw Error("principal point: cx and cy should be finite numbers");
  }
  if (!positive(near) || !std::isfinite(far) || far <= near) {
    throw Error("range of sight: found near " + fixed(near, 3) + " m, far " + fixed(far, 3) +
                " m; 0 < near < far should hold");
  }
  checkDistortion(distortion);
  largest_angle_ = lens::largestAngle(distortion);
}

std::optional<Eigen::Vector2d> CameraModel::project(const Eigen::Vector3d& p_C) const {
  if (!((hasNearPlane() ? p_C.z() : p_C.norm()) >= near_)) return std::nullopt;
  if (isStraight(distortion_)) {
    return Eigen::Vector2d(intrinsics_.fx * p_C.x() / p_C.z() + intrinsics_.cx,
                           intrinsics_.fy * p_C.y() / p_C.z() + intrinsics_.cy);
  }
  const auto place = lens::distort(distortion_, largest_angle_, p_C);
  if (!place) return std::nullopt;
  return Eigen::Vector2d(intrinsics_.fx * place->x() + intrinsics_.cx,
                         intrinsics_.fy * place->y() + intrinsics_.cy);
}

std::optional<Eigen::Vector3d> CameraModel::ray(const Eigen::Vector2d& pixel) const {
  return lens::undistort(distortion_, largest_angle_,
                         {(pixel.x() - intrinsics_.cx) / intrinsics_.fx,
                          (pixel.y() - intrinsics_.cy) / intrinsics_.fy});
}

bool CameraModel::isPinhole() const {
  // Without coefficients the polynomials are 1, but a fisheye's radius is still the angle and not
  // its tangent.
  return !lens::modelOf(distortion_.model).bends_without_coefficients &&
         std::all_of(distortion_.coefficients.begin(), distortion_.coefficients.end(),
                     [](double coefficient) { return coefficient == 0.0; });
}

bool CameraModel::hasNearPlane() const {
  return lens::modelOf(distortion_.model).functions->has_near_plane;
}

std::optional<double> CameraModel::radiusAt(double angle) const {
  return lens::modelOf(distortion_.model).functions->radiusAt(distortion_, angle);
}

double CameraModel::angleAt(double radius) const {
  return lens::modelOf(distortion_.model).functions->angleAt(distortion_, radius);
}

std::optional<Box> CameraModel::projectedBounds(
    const std::vector<Eigen::Vector3d>& points_C) const {
  if (!hasNearPlane()) {
    const bool too_near =
        std::all_of(points_C.begin(), points_C.end(),
                    [this](const Eigen::Vector3d& point) { return point.norm() < near_; });
    return too_near ? std::nullopt : lens::curvedBounds(*this, points_C);
  }
  const std::vector<Eigen::Vector3d> corners = clippedCorners(points_C, near_);
  if (!isStraight(distortion_)) return lens::curvedBounds(*this, corners);
  std::optional<Box> box;
  for (const Eigen::Vector3d& corner : corners) {
    if (const auto pixel = project(corner)) expand(box, *pixel);
  }
  return box;
}

Box CameraModel::imageBounds() const { return {-0.5, -0.5, width_ - 0.5, height_ - 0.5}; }

}  // namespace v2
}  // namespace synthetic_dataset

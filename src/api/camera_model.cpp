#include "synthetic_dataset/camera_model.h"

#include <cmath>
#include <string>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {
inline namespace v1 {
namespace {

constexpr int kLargestImage = 16384;  // OpenGL's and PNG readers' common limit for one side [px]

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

}  // namespace

CameraModel::CameraModel(int width, int height, const Intrinsics& intrinsics, double near,
                         double far, const Distortion& distortion)
    : width_(width),
      height_(height),
      intrinsics_(intrinsics),
      distortion_(distortion),
      near_(near),
      far_(far) {
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
                " m; it should hold that 0 < near < far");
  }
}

std::optional<Eigen::Vector2d> CameraModel::project(const Eigen::Vector3d& p_C) const {
  if (!(p_C.z() >= near_)) return std::nullopt;
  return Eigen::Vector2d(intrinsics_.fx * p_C.x() / p_C.z() + intrinsics_.cx,
                         intrinsics_.fy * p_C.y() / p_C.z() + intrinsics_.cy);
}

std::optional<Eigen::Vector3d> CameraModel::ray(const Eigen::Vector2d& pixel) const {
  return Eigen::Vector3d((pixel.x() - intrinsics_.cx) / intrinsics_.fx,
                         (pixel.y() - intrinsics_.cy) / intrinsics_.fy, 1.0)
      .normalized();
}

std::optional<Box> CameraModel::projectedBounds(
    const std::vector<Eigen::Vector3d>& points_C) const {
  std::optional<Box> box;
  std::vector<const Eigen::Vector3d*> in_front;
  std::vector<const Eigen::Vector3d*> behind;
  for (const Eigen::Vector3d& point : points_C) {
    if (const auto pixel = project(point)) {
      in_front.push_back(&point);
      expand(box, *pixel);
    } else {
      behind.push_back(&point);
    }
  }
  // The hull's edges that cross the near plane are among the segments between a point in front and
  // one behind; the other segments run inside the hull, so their crossings do not widen the box.
  for (const Eigen::Vector3d* a : in_front) {
    for (const Eigen::Vector3d* b : behind) {
      const double share = (near_ - a->z()) / (b->z() - a->z());
      Eigen::Vector3d crossing = *a + share * (*b - *a);
      crossing.z() = near_;
      if (const auto pixel = project(crossing)) expand(box, *pixel);
    }
  }
  return box;
}

Box CameraModel::imageBounds() const { return {-0.5, -0.5, width_ - 0.5, height_ - 0.5}; }

}  // namespace v1
}  // namespace synthetic_dataset

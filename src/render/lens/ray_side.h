#pragma once

#include <Eigen/Core>

#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {

/// One side of a triangle whose corners are in right-handed order in the image (where v points
/// down).
class RaySide {
 public:
  RaySide(const Eigen::Vector2f& from, const Eigen::Vector2f& to) {
    const bool turned = from.x() > to.x() || (from.x() == to.x() && from.y() > to.y());
    const Eigen::Vector2f& start = turned ? to : from;
    const Eigen::Vector2f along = turned ? Eigen::Vector2f(from - to) : Eigen::Vector2f(to - from);
    const float sign = turned ? -1.0F : 1.0F;
    u_ = lanes(start.x());
    v_ = lanes(start.y());
    along_u_ = lanes(sign * along.x());
    along_v_ = lanes(sign * along.y());
  }

  /// Whether points [cell] are inside; those on the side itself are.
  [[nodiscard]] Lanes inside(const Lanes& u, const Lanes& v) const {
    return along_u_ * (v - v_) >= (u - u_) * along_v_;
  }

 private:
  Lanes u_, v_, along_u_, along_v_;
};

}  // namespace synthetic_dataset::render

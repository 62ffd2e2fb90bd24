#include "randomize/placement/object_row.h"

#include <cmath>

#include <Eigen/Geometry>

#include "randomize/placement/random_place.h"

namespace synthetic_dataset::randomize {

ObjectRow::ObjectRow(const Volume& volume, double widest, std::size_t count,
                     base::RandomSource& source)
    : volume_(volume) {
  constexpr double kClosest = 1.1;   // between centres, as a multiple of the greatest width
  constexpr double kFarthest = 3.0;  // between centres, as a multiple of the greatest width
  const Eigen::Vector3d middle_G = drawWithin(volume, source);
  const double direction = source.angle();
  const double apart = widest * std::exp(source.uniform(std::log(kClosest), std::log(kFarthest)));
  step_G_ = apart * Eigen::Vector3d(std::cos(direction), std::sin(direction), 0.0);
  first_G_ = middle_G - 0.5 * static_cast<double>(count - 1) * step_G_;
  heading_ = source.angle();
}

std::optional<Pose> ObjectRow::place(std::size_t number, base::RandomSource& source) const {
  constexpr double kUneven = 0.06;  // as a fraction of the spacing
  constexpr double kTurned = 0.1;   // [rad]
  const double apart = step_G_.norm();
  Eigen::Vector3d place_G = first_G_ + static_cast<double>(number) * step_G_;
  place_G.x() += kUneven * apart * source.normal();
  place_G.y() += kUneven * apart * source.normal();
  const Eigen::AngleAxisd turn(heading_ + kTurned * source.normal(), Eigen::Vector3d::UnitZ());
  const bool is_inside = (place_G.array() >= volume_.low.array()).all() &&
                         (place_G.array() <= volume_.high.array()).all();
  if (!is_inside) return std::nullopt;
  return makePose(place_G, Eigen::Quaterniond(turn));
}

}  // namespace synthetic_dataset::randomize

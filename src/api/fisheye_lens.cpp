#include "api/fisheye_lens.h"

#include <algorithm>
#include <cmath>

#include "api/increasing_function.h"

namespace synthetic_dataset::lens {
namespace {

Slope fisheyeRadius(const Distortion& distortion, double angle) {
  const auto& k = distortion.coefficients;
  const double t = angle * angle;
  return {angle * (1.0 + t * (k[0] + t * (k[1] + t * (k[2] + t * k[3])))),
          1.0 + t * (3.0 * k[0] + t * (5.0 * k[1] + t * (7.0 * k[2] + t * 9.0 * k[3])))};
}

std::optional<double> angleItself(const Distortion& /*distortion*/, double angle) {
  if (!(angle <= M_PI)) return std::nullopt;
  return angle;
}

double radiusItself(const Distortion& /*distortion*/, double radius) {
  return std::min(radius, M_PI);
}

bool fisheyeIsOneToOne(const Distortion& distortion, double angle) {
  return fisheyeRadius(distortion, angle).slope > 0.0;
}

std::optional<Eigen::Vector2d> fisheyePlace(const Distortion& distortion, double largest_angle,
                                            const Eigen::Vector3d& direction) {
  const double across = direction.head<2>().norm();
  const double angle = std::atan2(across, direction.z());
  if (!(angle <= largest_angle)) return std::nullopt;
  if (across == 0.0) {  // on the axis; behind the camera it has no single place
    return direction.z() > 0.0 ? std::optional(Eigen::Vector2d(0.0, 0.0)) : std::nullopt;
  }
  return Eigen::Vector2d(direction.head<2>() * (fisheyeRadius(distortion, angle).value / across));
}

std::optional<Eigen::Vector3d> fisheyeRay(const Distortion& distortion, double largest_angle,
                                          const Eigen::Vector2d& place) {
  const double wanted = place.norm();
  if (wanted == 0.0) return Eigen::Vector3d(0.0, 0.0, 1.0);
  if (!(fisheyeRadius(distortion, largest_angle).value >= wanted)) return std::nullopt;
  const auto along = [&](double angle) { return fisheyeRadius(distortion, angle); };
  const double angle = solveIncreasing(along, wanted, largest_angle);
  const Eigen::Vector2d across = place * (std::sin(angle) / wanted);
  return Eigen::Vector3d(across.x(), across.y(), std::cos(angle));
}

}  // namespace

const LensFunctions kFisheye = {false,        angleItself, radiusItself, fisheyeIsOneToOne,
                                fisheyePlace, fisheyeRay};

}  // namespace synthetic_dataset::lens

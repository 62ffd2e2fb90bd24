#include "api/plane_lens.h"

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "api/plane_bending.h"

namespace synthetic_dataset::lens {
namespace {

constexpr double kRightAngle = 0.5 * M_PI;

std::optional<double> tangentOf(const Distortion& /*distortion*/, double angle) {
  if (!(angle < kRightAngle)) return std::nullopt;
  return std::tan(angle);
}

double arctangentOf(const Distortion& /*distortion*/, double radius) { return std::atan(radius); }

double largestRadius(double largest_angle) {
  return largest_angle < kRightAngle ? std::tan(largest_angle)
                                     : std::numeric_limits<double>::infinity();
}

/// Where the ray meets the plane; nullopt beyond the largest angle.
std::optional<Eigen::Vector2d> onPlane(double largest_angle, const Eigen::Vector3d& direction) {
  if (!(direction.z() > 0.0)) return std::nullopt;
  const Eigen::Vector2d x = direction.head<2>() / direction.z();
  if (!(x.norm() <= largestRadius(largest_angle))) return std::nullopt;
  return x;
}

std::optional<Eigen::Vector3d> rayThrough(double largest_angle, const Eigen::Vector2d& x) {
  if (x.norm() > largestRadius(largest_angle)) return std::nullopt;
  return Eigen::Vector3d(x.x(), x.y(), 1.0).normalized();
}

bool pinholeIsOneToOne(const Distortion& /*distortion*/, double /*angle*/) { return true; }

std::optional<Eigen::Vector2d> pinholePlace(const Distortion& /*distortion*/, double largest_angle,
                                            const Eigen::Vector3d& direction) {
  return onPlane(largest_angle, direction);
}

std::optional<Eigen::Vector3d> pinholeRay(const Distortion& /*distortion*/, double largest_angle,
                                          const Eigen::Vector2d& place) {
  return rayThrough(largest_angle, place);
}

bool bentIsOneToOne(const Distortion& distortion, double angle) {
  return isOneToOne(distortion.coefficients, std::tan(angle));
}

std::optional<Eigen::Vector2d> bentPlace(const Distortion& distortion, double largest_angle,
                                         const Eigen::Vector3d& direction) {
  const auto x = onPlane(largest_angle, direction);
  return x ? bend(distortion.coefficients, *x) : std::nullopt;
}

std::optional<Eigen::Vector3d> bentRay(const Distortion& distortion, double largest_angle,
                                       const Eigen::Vector2d& place) {
  const auto x = unbend(distortion.coefficients, largestRadius(largest_angle), place);
  return x ? rayThrough(largest_angle, *x) : std::nullopt;
}

}  // namespace

const LensFunctions kPinhole = {true,         tangentOf, arctangentOf, pinholeIsOneToOne,
                                pinholePlace, pinholeRay};

const LensFunctions kBentPinhole = {true,           tangentOf, arctangentOf,
                                    bentIsOneToOne, bentPlace, bentRay};

}  // namespace synthetic_dataset::lens

#include "api/lens.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

namespace synthetic_dataset::lens {
namespace {

constexpr double kHalfPi = 0.5 * M_PI;

/// A function's value and its derivative.
struct Value {
  double value = 0.0;
  double slope = 0.0;
};

bool isEquidistant(const Distortion& distortion) {
  return distortion.model == DistortionModel::kEquidistant;
}

/// theta_d = theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4 theta^8), as cv::fisheye has it.
Value fisheyeRadius(const Distortion& distortion, double angle) {
  const auto& k = distortion.coefficients;
  const double t = angle * angle;
  return {angle * (1.0 + t * (k[0] + t * (k[1] + t * (k[2] + t * k[3])))),
          1.0 + t * (3.0 * k[0] + t * (5.0 * k[1] + t * (7.0 * k[2] + t * 9.0 * k[3])))};
}

/// The radial factor (1 + k1 s + k2 s^2 + k3 s^3) / (1 + k4 s + k5 s^2 + k6 s^3), with s = r^2 and
/// the derivative by s. Not a number past a pole of the denominator.
Value radialFactor(const Distortion& distortion, double s) {
  const auto& k = distortion.coefficients;  // k1, k2, p1, p2, k3, k4, k5, k6
  const double above = 1.0 + s * (k[0] + s * (k[1] + s * k[4]));
  const double below = 1.0 + s * (k[5] + s * (k[6] + s * k[7]));
  const double above_slope = k[0] + s * (2.0 * k[1] + s * 3.0 * k[4]);
  const double below_slope = k[5] + s * (2.0 * k[6] + s * 3.0 * k[7]);
  if (!(below > 0.0)) return {std::nan(""), std::nan("")};
  return {above / below, (above_slope * below - above * below_slope) / (below * below)};
}

/// r times the radial factor, by r.
Value radius(const Distortion& distortion, double r) {
  const Value factor = radialFactor(distortion, r * r);
  return {r * factor.value, factor.value + 2.0 * r * r * factor.slope};
}

/// (p2, p1): the tangential terms are 2 (p.x) x + |x|^2 p.
Eigen::Vector2d tangential(const Distortion& distortion) {
  return {distortion.coefficients[3], distortion.coefficients[2]};
}

Eigen::Vector2d distortPlane(const Distortion& distortion, const Eigen::Vector2d& x) {
  const Eigen::Vector2d p = tangential(distortion);
  const double s = x.squaredNorm();
  return radialFactor(distortion, s).value * x + 2.0 * p.dot(x) * x + s * p;
}

Eigen::Matrix2d planeJacobian(const Distortion& distortion, const Eigen::Vector2d& x) {
  const Eigen::Vector2d p = tangential(distortion);
  const Value factor = radialFactor(distortion, x.squaredNorm());
  return (factor.value + 2.0 * p.dot(x)) * Eigen::Matrix2d::Identity() +
         2.0 * factor.slope * x * x.transpose() + 2.0 * (x * p.transpose() + p * x.transpose());
}

/// Whether the distortion is one to one about this angle.
///
/// On the plane z = 1 its Jacobian is symmetric, and a map whose Jacobian is positive definite on a
/// disc is one to one there. The radial part's eigenvalues are the factor and the radius's slope;
/// those of the tangential part, 2 (p x^T + x p^T + p.x I), are at least -6 |p| r.
bool isOneToOne(const Distortion& distortion, double angle) {
  if (isEquidistant(distortion)) return fisheyeRadius(distortion, angle).slope > 0.0;
  const double r = std::tan(angle);
  const double least = std::min(radialFactor(distortion, r * r).value, radius(distortion, r).slope);
  return least > 6.0 * tangential(distortion).norm() * r;
}

/// Where an increasing function with f(0) = 0 reaches a value in [0, end]: Newton's steps, and
/// halving wherever they would leave the interval that holds the answer.
template <class Function>
double solveIncreasing(const Function& function, double wanted, double end) {
  double low = 0.0;
  double high = end;
  double x = std::min(wanted, 0.5 * end);
  for (int i = 0; i < 200 && high - low > 1e-16 * high; ++i) {
    const Value f = function(x);
    if (f.value == wanted) return x;
    (f.value < wanted ? low : high) = x;
    const double newton = x - (f.value - wanted) / f.slope;
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (std::abs(next - x) <= 1e-16 * x) return next;
    x = next;
  }
  return x;
}

/// The end of an interval from 0 in which the radius reaches `wanted`, or the nearest to it.
double radiusEnd(const Distortion& distortion, double largest_angle, double wanted) {
  constexpr double kFarthest = 1e9;
  if (largest_angle < kHalfPi) return std::tan(largest_angle);
  double end = std::max(1.0, 2.0 * wanted);
  while (end < kFarthest && !(radius(distortion, end).value >= wanted)) end *= 2.0;
  return end;
}

/// Newton's method on the plane, shortened until a step stays in the disc and comes nearer.
std::optional<Eigen::Vector2d> undistortPlane(const Distortion& distortion, double largest_angle,
                                              const Eigen::Vector2d& place) {
  const double wanted = place.norm();
  const double end = radiusEnd(distortion, largest_angle, wanted);
  const bool has_tangential = !tangential(distortion).isZero(0.0);
  if (!has_tangential && !(radius(distortion, end).value >= wanted)) return std::nullopt;
  if (wanted == 0.0) return Eigen::Vector2d(0.0, 0.0);
  const auto along = [&](double r) { return radius(distortion, r); };
  Eigen::Vector2d x = place * (solveIncreasing(along, wanted, end) / wanted);
  if (!has_tangential) return x;
  const double enough = 1e-14 * (1.0 + wanted);
  Eigen::Vector2d error = distortPlane(distortion, x) - place;
  for (int i = 0; i < 50 && error.norm() > enough; ++i) {
    const Eigen::Vector2d step = planeJacobian(distortion, x).inverse() * error;
    double share = 1.0;
    const auto next = [&] { return Eigen::Vector2d(x - share * step); };
    const auto nextError = [&] {
      return Eigen::Vector2d(distortPlane(distortion, next()) - place);
    };
    while (share > 1e-6 && !(next().norm() <= end && nextError().norm() < error.norm())) {
      share *= 0.5;
    }
    if (share <= 1e-6) break;
    const Eigen::Vector2d better = nextError();
    x = next();
    error = better;
  }
  if (!(error.norm() <= 1e3 * enough)) return std::nullopt;
  return x;
}

std::optional<Eigen::Vector2d> distortFisheye(const Distortion& distortion, double largest_angle,
                                              const Eigen::Vector3d& direction) {
  const double across = direction.head<2>().norm();
  const double angle = std::atan2(across, direction.z());
  if (!(angle <= largest_angle)) return std::nullopt;
  if (across == 0.0) {  // the axis; behind the camera it has no one place
    return direction.z() > 0.0 ? std::optional(Eigen::Vector2d(0.0, 0.0)) : std::nullopt;
  }
  return Eigen::Vector2d(direction.head<2>() * (fisheyeRadius(distortion, angle).value / across));
}

std::optional<Eigen::Vector3d> undistortFisheye(const Distortion& distortion, double largest_angle,
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

double largestAngle(const Distortion& distortion) {
  constexpr double kStep = 1e-4;  // [rad]
  const double end = std::min(isEquidistant(distortion) ? M_PI : kHalfPi, distortion.cutoff_angle);
  if (distortion.model == DistortionModel::kNone) return end;
  double sound = 0.0;
  while (sound + kStep < end && isOneToOne(distortion, sound + kStep)) sound += kStep;
  if (sound + kStep >= end) return end;
  double folded = sound + kStep;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (sound + folded);
    (isOneToOne(distortion, middle) ? sound : folded) = middle;
  }
  return sound;
}

std::optional<Eigen::Vector2d> distort(const Distortion& distortion, double largest_angle,
                                       const Eigen::Vector3d& direction) {
  if (isEquidistant(distortion)) return distortFisheye(distortion, largest_angle, direction);
  if (!(direction.z() > 0.0)) return std::nullopt;
  const Eigen::Vector2d x = direction.head<2>() / direction.z();
  if (largest_angle < kHalfPi && !(x.norm() <= std::tan(largest_angle))) return std::nullopt;
  if (distortion.model == DistortionModel::kNone) return x;
  return distortPlane(distortion, x);
}

std::optional<Eigen::Vector3d> undistort(const Distortion& distortion, double largest_angle,
                                         const Eigen::Vector2d& place) {
  if (isEquidistant(distortion)) return undistortFisheye(distortion, largest_angle, place);
  const auto x = distortion.model == DistortionModel::kNone
                     ? std::optional(place)
                     : undistortPlane(distortion, largest_angle, place);
  if (!x || (largest_angle < kHalfPi && x->norm() > std::tan(largest_angle))) return std::nullopt;
  return Eigen::Vector3d(x->x(), x->y(), 1.0).normalized();
}

}  // namespace synthetic_dataset::lens

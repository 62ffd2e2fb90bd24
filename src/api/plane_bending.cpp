#include "api/plane_bending.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "api/increasing_function.h"

namespace synthetic_dataset::lens {
namespace {

/// The radial factor (1 + k1 s + k2 s^2 + k3 s^3) / (1 + k4 s + k5 s^2 + k6 s^3), with s = r^2, and
/// its derivative with respect to s. NaN where the denominator is not positive.
Slope radialFactor(const Bending& k, double s) {
  const double above = 1.0 + s * (k[0] + s * (k[1] + s * k[4]));
  const double below = 1.0 + s * (k[5] + s * (k[6] + s * k[7]));
  const double above_slope = k[0] + s * (2.0 * k[1] + s * 3.0 * k[4]);
  const double below_slope = k[5] + s * (2.0 * k[6] + s * 3.0 * k[7]);
  if (!(below > 0.0)) return {std::nan(""), std::nan("")};
  return {above / below, (above_slope * below - above * below_slope) / (below * below)};
}

/// r times the radial factor, and its derivative with respect to r.
Slope bentRadius(const Bending& k, double r) {
  const Slope factor = radialFactor(k, r * r);
  return {r * factor.value, factor.value + 2.0 * r * r * factor.slope};
}

/// (p2, p1): the tangential terms are 2 (p.x) x + |x|^2 p.
Eigen::Vector2d tangential(const Bending& k) { return {k[3], k[2]}; }

bool hasPrism(const Bending& k) {
  return k[8] != 0.0 || k[9] != 0.0 || k[10] != 0.0 || k[11] != 0.0;
}

/// A thin prism moves a place by (s1 s + s2 s^2, s3 s + s4 s^2), with s = r^2.
Eigen::Vector2d prism(const Bending& k, double s) {
  return {s * (k[8] + s * k[9]), s * (k[10] + s * k[11])};
}

/// The prism's Jacobian is a x^T with this a.
Eigen::Vector2d prismSlope(const Bending& k, double s) {
  return {2.0 * k[8] + 4.0 * s * k[9], 2.0 * k[10] + 4.0 * s * k[11]};
}

/// The projection to a sensor that is tilted by tau_x and tau_y.
Eigen::Matrix3d tiltOf(const Bending& k) {
  const double cx = std::cos(k[12]);
  const double sx = std::sin(k[12]);
  const double cy = std::cos(k[13]);
  const double sy = std::sin(k[13]);
  Eigen::Matrix3d R;
  R << cy, sy * sx, -sy * cx, 0.0, cx, sx, sy, -cy * sx, cy * cx;
  Eigen::Matrix3d onto;
  onto << R(2, 2), 0.0, -R(0, 2), 0.0, R(2, 2), -R(1, 2), 0.0, 0.0, 1.0;
  return onto * R;
}

bool hasTilt(const Bending& k) { return k[12] != 0.0 || k[13] != 0.0; }

/// The distorted position without the sensor's tilt.
Eigen::Vector2d bendUpright(const Bending& k, const Eigen::Vector2d& x) {
  const Eigen::Vector2d p = tangential(k);
  const double s = x.squaredNorm();
  const Eigen::Vector2d bent = radialFactor(k, s).value * x + 2.0 * p.dot(x) * x + s * p;
  return hasPrism(k) ? Eigen::Vector2d(bent + prism(k, s)) : bent;
}

Eigen::Matrix2d jacobian(const Bending& k, const Eigen::Vector2d& x) {
  const Eigen::Vector2d p = tangential(k);
  const Slope factor = radialFactor(k, x.squaredNorm());
  const Eigen::Matrix2d J = (factor.value + 2.0 * p.dot(x)) * Eigen::Matrix2d::Identity() +
                            2.0 * factor.slope * x * x.transpose() +
                            2.0 * (x * p.transpose() + p * x.transpose());
  if (!hasPrism(k)) return J;
  return J + prismSlope(k, x.squaredNorm()) * x.transpose();
}

/// The end of an interval from 0 in which the bent radius reaches `wanted` if it can.
double radiusEnd(const Bending& k, double end, double wanted) {
  constexpr double kFarthest = 1e9;
  if (std::isfinite(end)) return end;
  double far = std::max(1.0, 2.0 * wanted);
  while (far < kFarthest && !(bentRadius(k, far).value >= wanted)) far *= 2.0;
  return far;
}

/// Newton's method on the plane; steps are shortened until they stay in the disc and reduce the
/// error.
std::optional<Eigen::Vector2d> refined(const Bending& k, double end, const Eigen::Vector2d& place,
                                       Eigen::Vector2d x) {
  const double enough = 1e-14 * (1.0 + place.norm());
  Eigen::Vector2d error = bendUpright(k, x) - place;
  for (int i = 0; i < 50 && error.norm() > enough; ++i) {
    const Eigen::Vector2d step = jacobian(k, x).inverse() * error;
    double share = 1.0;
    const auto next = [&] { return Eigen::Vector2d(x - share * step); };
    const auto nextError = [&] { return Eigen::Vector2d(bendUpright(k, next()) - place); };
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

std::optional<Eigen::Vector2d> unbendUpright(const Bending& k, double largest,
                                             const Eigen::Vector2d& place) {
  const double wanted = place.norm();
  const double end = radiusEnd(k, largest, wanted);
  const bool is_radial = tangential(k).isZero(0.0) && !hasPrism(k);
  if (is_radial && !(bentRadius(k, end).value >= wanted)) return std::nullopt;
  if (wanted == 0.0) return Eigen::Vector2d(0.0, 0.0);
  const auto along = [&](double r) { return bentRadius(k, r); };
  const Eigen::Vector2d x = place * (solveIncreasing(along, wanted, end) / wanted);
  return is_radial ? x : refined(k, end, place, x);
}

/// The position of a point of the plane in a view of it; nullopt if the point is behind the view.
std::optional<Eigen::Vector2d> seenBy(const Eigen::Matrix3d& view, const Eigen::Vector2d& x) {
  const Eigen::Vector3d seen = view * x.homogeneous();
  if (!(seen.z() > 0.0)) return std::nullopt;
  return Eigen::Vector2d(seen.head<2>() / seen.z());
}

}  // namespace

std::optional<Eigen::Vector2d> bend(const Bending& k, const Eigen::Vector2d& x) {
  const Eigen::Vector2d upright = bendUpright(k, x);
  return hasTilt(k) ? seenBy(tiltOf(k), upright) : upright;
}

bool isOneToOne(const Bending& k, double r) {
  const double least = std::min(radialFactor(k, r * r).value, bentRadius(k, r).slope);
  return least > (6.0 * tangential(k).norm() + prismSlope(k, r * r).norm()) * r;
}

std::optional<Eigen::Vector2d> unbend(const Bending& k, double end, const Eigen::Vector2d& place) {
  if (!hasTilt(k)) return unbendUpright(k, end, place);
  const auto upright = seenBy(tiltOf(k).inverse(), place);
  return upright ? unbendUpright(k, end, *upright) : std::nullopt;
}

}  // namespace synthetic_dataset::lens

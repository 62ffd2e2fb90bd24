#include "api/sphere_lenses.h"

#include <cmath>
#include <limits>

#include "api/plane_bending.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::lens {
namespace {

/// The angle with this radius, by bisection: the radius grows from 0 as long as it exists.
template <class RadiusAt>
double angleByHalving(const RadiusAt& radiusAt, const Distortion& distortion, double radius) {
  double low = 0.0;
  double high = M_PI;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    const auto reached = radiusAt(distortion, middle);
    (reached && *reached < radius ? low : high) = middle;
  }
  return low;
}

double angleOf(const Eigen::Vector3d& direction) {
  return std::atan2(direction.head<2>().norm(), direction.z());
}

/// Whether a direction is visible at all. What is straight behind has no single place.
bool isWithin(const Eigen::Vector3d& direction, double largest_angle) {
  const bool is_behind = direction.head<2>().isZero(0.0) && !(direction.z() > 0.0);
  return !is_behind && angleOf(direction) <= largest_angle;
}

// --- Omnidirectional: xi, k1, k2, p1, p2, skew ---

double mirrorOf(const Distortion& distortion) { return distortion.coefficients[0]; }

Bending bendingOf(const Distortion& distortion) {
  const auto& c = distortion.coefficients;
  return {c[1], c[2], c[3], c[4]};
}

/// sin / (cos + xi). It increases as long as 1 + xi cos is above 0.
std::optional<double> omniRadius(const Distortion& distortion, double angle) {
  const double xi = mirrorOf(distortion);
  const double below = std::cos(angle) + xi;
  if (!(angle <= M_PI && below > 0.0 && 1.0 + xi * std::cos(angle) > 0.0)) return std::nullopt;
  return std::sin(angle) / below;
}

double omniAngle(const Distortion& distortion, double radius) {
  return angleByHalving(omniRadius, distortion, radius);
}

bool omniIsOneToOne(const Distortion& distortion, double angle) {
  const auto radius = omniRadius(distortion, angle);
  return radius && isOneToOne(bendingOf(distortion), *radius);
}

std::optional<Eigen::Vector2d> omniPlace(const Distortion& distortion, double largest_angle,
                                         const Eigen::Vector3d& direction) {
  if (!isWithin(direction, largest_angle)) return std::nullopt;
  const double below = direction.z() + mirrorOf(distortion) * direction.norm();
  if (!(below > 0.0)) return std::nullopt;
  auto place = bend(bendingOf(distortion), direction.head<2>() / below);
  if (place) place->x() += distortion.coefficients[5] * place->y();
  return place;
}

std::optional<Eigen::Vector3d> omniRay(const Distortion& distortion, double largest_angle,
                                       const Eigen::Vector2d& place) {
  const double xi = mirrorOf(distortion);
  const double end =
      omniRadius(distortion, largest_angle).value_or(std::numeric_limits<double>::infinity());
  const Eigen::Vector2d upright(place.x() - distortion.coefficients[5] * place.y(), place.y());
  const auto x = unbend(bendingOf(distortion), end, upright);
  if (!x) return std::nullopt;
  const double s = x->squaredNorm();
  const double root = 1.0 + (1.0 - xi * xi) * s;
  if (!(root >= 0.0)) return std::nullopt;
  const double on_sphere = (xi + std::sqrt(root)) / (s + 1.0);
  const Eigen::Vector3d ray(on_sphere * x->x(), on_sphere * x->y(), on_sphere - xi);
  if (!isWithin(ray, largest_angle)) return std::nullopt;
  return ray.normalized();
}

// --- Double sphere: xi, alpha ---

/// The cosine beyond which such a lens does not see (equations 43 to 45 of the paper).
double leastCosine(double xi, double alpha) {
  const double w1 = alpha <= 0.5 ? alpha / (1.0 - alpha) : (1.0 - alpha) / alpha;
  return -(w1 + xi) / std::sqrt(2.0 * w1 * xi + xi * xi + 1.0);
}

/// sin / (alpha d2 + (1 - alpha) (xi + cos)), d2 = sqrt(1 + 2 xi cos + xi^2).
std::optional<double> sphereRadius(const Distortion& distortion, double angle) {
  const double xi = distortion.coefficients[0];
  const double alpha = distortion.coefficients[1];
  const double c = std::cos(angle);
  const double d2 = std::sqrt(1.0 + 2.0 * xi * c + xi * xi);
  const double below = alpha * d2 + (1.0 - alpha) * (xi + c);
  if (!(angle <= M_PI && c > leastCosine(xi, alpha) && below > 0.0)) return std::nullopt;
  return std::sin(angle) / below;
}

double sphereAngle(const Distortion& distortion, double radius) {
  return angleByHalving(sphereRadius, distortion, radius);
}

bool sphereIsOneToOne(const Distortion& distortion, double angle) {
  return sphereRadius(distortion, angle).has_value();
}

/// Equations 40 to 42 of the paper.
std::optional<Eigen::Vector2d> spherePlace(const Distortion& distortion, double largest_angle,
                                           const Eigen::Vector3d& direction) {
  if (!isWithin(direction, largest_angle)) return std::nullopt;
  const double xi = distortion.coefficients[0];
  const double alpha = distortion.coefficients[1];
  const double d1 = direction.norm();
  const double z = xi * d1 + direction.z();
  const double d2 = std::sqrt(direction.head<2>().squaredNorm() + z * z);
  const double below = alpha * d2 + (1.0 - alpha) * z;
  if (!(below > 0.0)) return std::nullopt;
  return Eigen::Vector2d(direction.head<2>() / below);
}

/// Equations 46 to 50 of the paper.
std::optional<Eigen::Vector3d> sphereRay(const Distortion& distortion, double largest_angle,
                                         const Eigen::Vector2d& place) {
  const double xi = distortion.coefficients[0];
  const double alpha = distortion.coefficients[1];
  const double s = place.squaredNorm();
  const double root = 1.0 - (2.0 * alpha - 1.0) * s;
  if (!(root >= 0.0)) return std::nullopt;
  const double z = (1.0 - alpha * alpha * s) / (alpha * std::sqrt(root) + 1.0 - alpha);
  const double second_root = z * z + (1.0 - xi * xi) * s;
  if (!(second_root >= 0.0)) return std::nullopt;
  const double scale = (z * xi + std::sqrt(second_root)) / (z * z + s);
  const Eigen::Vector3d ray(scale * place.x(), scale * place.y(), scale * z - xi);
  if (!isWithin(ray, largest_angle)) return std::nullopt;
  return ray.normalized();
}

}  // namespace

const LensFunctions kOmnidirectionalLens = {false,          omniRadius, omniAngle,
                                            omniIsOneToOne, omniPlace,  omniRay};

const LensFunctions kDoubleSphereLens = {false,       sphereRadius, sphereAngle, sphereIsOneToOne,
                                         spherePlace, sphereRay};

std::string omnidirectionalFault(const Distortion& distortion) {
  const double xi = mirrorOf(distortion);
  if (xi > -1.0) return "";
  return "found xi " + fixed(xi, 4) + "; it should be above -1";
}

std::string doubleSphereFault(const Distortion& distortion) {
  const double xi = distortion.coefficients[0];
  const double alpha = distortion.coefficients[1];
  if (xi > -1.0 && alpha >= 0.0 && alpha <= 1.0) return "";
  return "found xi " + fixed(xi, 4) + " and alpha " + fixed(alpha, 4) +
         "; xi should be above -1, alpha 0 to 1";
}

}  // namespace synthetic_dataset::lens

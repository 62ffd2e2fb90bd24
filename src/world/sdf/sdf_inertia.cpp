#include "world/sdf/sdf_inertia.h"

#include <cmath>

#include <Eigen/Eigenvalues>

#include "world/sdf/sdf_values.h"

namespace synthetic_dataset::world {
namespace {

/// Whether the principal moments are those of a solid: each above 0, and none larger than the other
/// two together (but for rounding).
bool isSolid(const Eigen::Matrix3d& moments) {
  if (!moments.allFinite()) return false;
  const Eigen::Vector3d principal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments, Eigen::EigenvaluesOnly).eigenvalues();
  constexpr double kRounding = 1e-6;
  return principal(0) > 0.0 && principal(2) <= (principal(0) + principal(1)) * (1.0 + kRounding);
}

/// SDF 1.0 has attributes, and 1 where the file says nothing.
Eigen::Matrix3d readMoments(const Element& inertia, const SourceLocation& location,
                            SdfReading& reading) {
  const auto at = [&](const char* name, double fallback) {
    return readNumber(inertia, name, fallback, location, reading);
  };
  const double xy = at("ixy", 0.0);
  const double xz = at("ixz", 0.0);
  const double yz = at("iyz", 0.0);
  Eigen::Matrix3d moments;
  moments << at("ixx", 1.0), xy, xz, xy, at("iyy", 1.0), yz, xz, yz, at("izz", 1.0);
  return moments;
}

}  // namespace

std::optional<Inertia> readInertia(const Element& link, const SourceLocation& location,
                                   SdfReading& reading) {
  const Element element = link.child("inertial");
  // The newest files may have it worked out from the collision shapes, which is done without one.
  if (!element || element.attribute("auto") == "true") return std::nullopt;
  const Pose X_LI = readPose(element, location, reading).pose;
  const Eigen::Matrix3d moments_I = readMoments(element.child("inertia"), location, reading);
  Inertia inertia;
  inertia.mass = readNumber(element, "mass", 1.0, location, reading);
  inertia.centre_of_mass_L = X_LI.translation();
  inertia.moments_L = X_LI.linear() * moments_I * X_LI.linear().transpose();
  if (inertia.mass > 0.0 && isSolid(inertia.moments_L)) return inertia;
  reading.findings.addNote(
      location, "its <inertial> is not that of a solid body; its collision shapes count");
  return std::nullopt;
}

}  // namespace synthetic_dataset::world

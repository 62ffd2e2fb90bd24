#include "randomize/placement/standing_place.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

namespace synthetic_dataset::randomize {
namespace {

constexpr double kDeepest = 1e4;  // [m] below the highest surface that is considered

/// Tolerances below this [m] cannot be checked: rays are cast in single precision.
constexpr double kLeastUnevenness = 1e-3;

const Eigen::Vector3d kDown(0.0, 0.0, -1.0);

}  // namespace

std::string reasonsText(const std::map<std::string, int>& misses) {
  std::vector<std::pair<int, std::string>> by_count;
  for (const auto& [reason, count] : misses) by_count.emplace_back(count, reason);
  std::sort(by_count.rbegin(), by_count.rend());
  constexpr std::size_t kMostTold = 4;
  std::string text;
  for (std::size_t i = 0; i < std::min(kMostTold, by_count.size()); ++i) {
    text += (i > 0 ? ", " : "") + std::to_string(by_count[i].first) + " " + by_count[i].second;
  }
  return text;
}

PoseOrReason StandingPlace::at(const Eigen::Vector2d& place_G, double heading,
                               const Cuboid& box_O) const {
  const Eigen::Vector3d above(place_G.x(), place_G.y(), options_.highest);
  const std::optional<world::RayHit> hit = surroundings_.cast(above, kDown, kDeepest);
  if (!hit) return "had nothing below to stand on";
  if (std::acos(std::min(1.0, hit->normal_W.z())) > options_.steepest) {
    return "would have stood on something steep";
  }
  const auto upright = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), hit->normal_W);
  const Eigen::AngleAxisd turn(heading, Eigen::Vector3d::UnitZ());
  Pose X_GO = makePose(above + hit->distance * kDown, upright * turn);
  X_GO.translation() -= X_GO.linear() * Eigen::Vector3d(0.0, 0.0, box_O.low.z());
  if (!liesEven(X_GO, box_O)) return "would have stuck out over an edge or stood across a step";
  return X_GO;
}

/// Whether there is a surface close to all corners of the thing's bottom.
bool StandingPlace::liesEven(const Pose& X_GO, const Cuboid& box_O) const {
  const double unevenness = std::max(options_.unevenness, kLeastUnevenness);
  for (const double x : {box_O.low.x(), box_O.high.x()}) {
    for (const double y : {box_O.low.y(), box_O.high.y()}) {
      const Eigen::Vector3d corner = X_GO * Eigen::Vector3d(x, y, box_O.low.z());
      const Eigen::Vector3d above = corner - unevenness * kDown;
      if (!surroundings_.cast(above, kDown, 2.0 * unevenness)) return false;
    }
  }
  return true;
}

}  // namespace synthetic_dataset::randomize

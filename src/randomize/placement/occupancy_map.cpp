#include "randomize/placement/occupancy_map.h"

#include <cmath>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::randomize {
namespace {

/// Keeps cell counts within the range of OpenCV's int, even for a map twice as fine and with a rim.
constexpr std::size_t kLongestSide = 1000000;  // [cells]

void checkSides(std::size_t width, std::size_t height, std::size_t cell_count) {
  const std::string sides = std::to_string(width) + " x " + std::to_string(height) + " cells";
  if (width == 0 || height == 0 || width > kLongestSide || height > kLongestSide) {
    throw Error("found a map of " + sides + "; it should have 1 to " +
                std::to_string(kLongestSide) + " a side");
  }
  if (width * height > kMostCells) {
    throw Error("found a map of " + sides + "; it should have at most " +
                std::to_string(kMostCells) + ", so coarser cells for a place of this size");
  }
  if (cell_count != width * height) {
    throw Error("found " + std::to_string(cell_count) + " cells of a map of " + sides);
  }
}

}  // namespace

OccupancyMap::OccupancyMap(std::size_t width, std::size_t height, double resolution,
                           const MapPose& X_GM, std::vector<Cell> cells)
    : width_(width),
      height_(height),
      resolution_(resolution),
      X_GM_(X_GM),
      R_GM_(Eigen::Rotation2Dd(X_GM.yaw).toRotationMatrix()),
      cells_(std::move(cells)) {
  checkSides(width, height, cells_.size());
  if (!std::isfinite(resolution) || resolution <= 0.0) {
    throw Error("found a resolution of " + Value(resolution).text() + " m; it should be above 0");
  }
  if (!Eigen::Vector4d(X_GM.x, X_GM.y, X_GM.z, X_GM.yaw).allFinite()) {
    throw Error("found a map pose that is not finite; it should be of finite numbers");
  }
}

std::optional<Cell> OccupancyMap::cellAt(const Eigen::Vector2d& p_G) const {
  const Eigen::Vector2d place = (toMap(p_G) / resolution_).array().floor();  // [cells]
  const bool is_inside = place.x() >= 0.0 && place.x() < static_cast<double>(width_) &&
                         place.y() >= 0.0 && place.y() < static_cast<double>(height_);
  if (!is_inside) return std::nullopt;
  return cell(static_cast<std::size_t>(place.x()), static_cast<std::size_t>(place.y()));
}

Eigen::Vector2d OccupancyMap::toGlobal(const Eigen::Vector2d& p_M) const {
  return R_GM_ * p_M + Eigen::Vector2d(X_GM_.x, X_GM_.y);
}

Eigen::Vector2d OccupancyMap::toMap(const Eigen::Vector2d& p_G) const {
  return R_GM_.transpose() * (p_G - Eigen::Vector2d(X_GM_.x, X_GM_.y));
}

}  // namespace synthetic_dataset::randomize

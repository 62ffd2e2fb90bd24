#include "randomize/appearance/variety/width_profile.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace synthetic_dataset::randomize {
namespace {

/// An edge of a triangle, by its lower and its higher end.
struct ProfileEdge {
  Eigen::Vector3d low;
  Eigen::Vector3d high;
};

/// The greatest distance of a model from its middle at each height.
class WidthProfile {
 public:
  WidthProfile(const world::Model& model, const ModelParts& parts)
      : axis_(parts.box_M.center().head<2>()) {
    for (const SurfacePart& part : parts.surfaces) {
      const std::vector<std::uint32_t>& indices = surfaceOf(model, part).mesh->indices;
      for (std::size_t k = 0; k + 2 < indices.size(); k += 3) {
        for (std::size_t i = 0; i < 3; ++i) {
          Eigen::Vector3d a = part.p_M[indices[k + i]];
          Eigen::Vector3d b = part.p_M[indices[k + (i + 1) % 3]];
          if (a.z() > b.z()) std::swap(a, b);
          if (a.z() < b.z()) edges_.push_back({a, b});
        }
      }
    }
  }

  [[nodiscard]] double radiusAt(double z) const {
    double radius = 0.0;
    for (const ProfileEdge& edge : edges_) {
      if (z < edge.low.z() || z > edge.high.z()) continue;
      const double t = (z - edge.low.z()) / (edge.high.z() - edge.low.z());
      const Eigen::Vector2d p = (edge.low + t * (edge.high - edge.low)).head<2>() - axis_;
      radius = std::max(radius, p.norm());
    }
    return radius;
  }

 private:
  Eigen::Vector2d axis_;
  std::vector<ProfileEdge> edges_;
};

}  // namespace

std::vector<HeightLevel> levelsOf(const world::Model& model, const ModelParts& parts) {
  constexpr int kHeights = 80;
  constexpr double kJump = 0.15;  // of the largest radius
  constexpr std::size_t kMost = 4;
  const double low = parts.box_M.min().z();
  const double high = parts.box_M.max().z();
  const double step = (high - low) / kHeights;
  const WidthProfile profile(model, parts);
  std::vector<double> radii;
  for (int i = 0; i < kHeights; ++i) radii.push_back(profile.radiusAt(low + (i + 0.5) * step));
  const double jump = kJump * *std::max_element(radii.begin(), radii.end());
  std::vector<HeightLevel> levels = {{low, high, radii.front(), radii.back()}};
  if (jump <= 0.0) return levels;
  for (std::size_t i = 0; i + 1 < radii.size(); ++i) {
    if (std::abs(radii[i + 1] - radii[i]) < jump) continue;
    double below = low + (static_cast<double>(i) + 0.5) * step;
    double above = below + step;
    const double middle = 0.5 * (radii[i] + radii[i + 1]);
    for (int halving = 0; halving < 12; ++halving) {
      const double z = 0.5 * (below + above);
      const bool is_below = (profile.radiusAt(z) > middle) == (radii[i] > middle);
      (is_below ? below : above) = z;
    }
    levels.back().high = above;
    levels.back().top_radius = radii[i];
    levels.push_back({above, high, radii[i + 1], radii.back()});
  }
  if (levels.size() > kMost) return {{low, high, radii.front(), radii.back()}};
  return levels;
}

std::size_t levelAt(const std::vector<HeightLevel>& levels, double z) {
  const double border = 1e-3 * (levels.back().high - levels.front().low);
  std::size_t level = 0;
  while (level + 1 < levels.size() && z > levels[level].high + border) ++level;
  return level;
}

}  // namespace synthetic_dataset::randomize

#include "render/shadows/held_casters.h"

#include <algorithm>
#include <cstddef>

#include "render/parts/bounds.h"

namespace synthetic_dataset::render {
namespace {

/// The most that some points of a link are apart with it in two places.
double farthest(const std::vector<Eigen::Vector3d>& points_L, const Pose& one, const Pose& other) {
  double most = 0.0;
  for (const Eigen::Vector3d& point : points_L) {
    most = std::max(most, (one * point - other * point).norm());
  }
  return most;
}

}  // namespace

std::vector<CasterPoses> heldForShadows(const std::vector<Part>& parts,
                                        const std::vector<const std::vector<Pose>*>& X_WL,
                                        const std::vector<ShadowProjection>& shadows,
                                        double texels) {
  std::vector<CasterPoses> held;
  for (const std::vector<Pose>* poses : X_WL) held.emplace_back(shadows.size(), *poses);
  std::vector<std::vector<Eigen::Vector3d>> corners(X_WL.empty() ? 0 : X_WL.front()->size());
  for (const Part& part : parts) {
    if (!part.casts_shadow || part.stands_still || part.bounds_V.isEmpty()) continue;
    for (const Eigen::Vector3d& corner : cornersOf(part.bounds_V)) {
      corners[part.link].push_back(part.X_LV * corner);
    }
  }
  for (std::size_t link = 0; link < corners.size(); ++link) {
    if (corners[link].empty()) continue;
    const auto at = [&](std::size_t time) -> const Pose& { return (*X_WL[time])[link]; };
    for (std::size_t shadow = 0; shadow < shadows.size(); ++shadow) {
      const double limit = texels * shadows[shadow].texel;
      for (std::size_t first = 0; first < held.size();) {
        std::size_t end = first + 1;
        while (end < held.size() && farthest(corners[link], at(first), at(end)) < limit) ++end;
        for (std::size_t time = first; time < end; ++time) {
          held[time][shadow][link] = at((first + end - 1) / 2);
        }
        first = end;
      }
    }
  }
  return held;
}

}  // namespace synthetic_dataset::render

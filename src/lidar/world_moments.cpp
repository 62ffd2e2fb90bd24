#include "lidar/world_moments.h"

#include <algorithm>

namespace synthetic_dataset::lidar {

MomentsAround momentsAround(const std::vector<WorldMoment>& moments, double time) {
  const auto after = std::upper_bound(
      moments.begin(), moments.end(), time,
      [](double t, const auto& moment) { return t < static_cast<double>(moment.offset.count()); });
  if (after == moments.begin()) return {};
  const auto index = static_cast<std::size_t>(after - moments.begin());
  if (after == moments.end()) return {index - 1, index - 1, 0.0};
  const auto from = static_cast<double>(moments[index - 1].offset.count());
  const auto to = static_cast<double>(after->offset.count());
  return {index - 1, index, (time - from) / (to - from)};
}

base::Placement placementAt(const std::vector<WorldMoment>& moments,
                            std::vector<base::Placement> WorldMoment::*poses, std::size_t index,
                            double time) {
  const MomentsAround around = momentsAround(moments, time);
  const base::Placement& before = (moments[around.before].*poses)[index];
  return base::between(before, (moments[around.after].*poses)[index], around.share);
}

}  // namespace synthetic_dataset::lidar

#include "lidar/world_moments.h"

#include <algorithm>
#include <iterator>

namespace synthetic_dataset::lidar {

base::Placement placementAt(const std::vector<WorldMoment>& moments,
                            std::vector<base::Placement> WorldMoment::*poses, std::size_t index,
                            double time) {
  const auto after = std::upper_bound(
      moments.begin(), moments.end(), time,
      [](double t, const auto& moment) { return t < static_cast<double>(moment.offset.count()); });
  if (after == moments.begin()) return (moments.front().*poses)[index];
  if (after == moments.end()) return (moments.back().*poses)[index];
  const auto before = std::prev(after);
  const auto from = static_cast<double>(before->offset.count());
  const auto to = static_cast<double>(after->offset.count());
  return base::between(((*before).*poses)[index], ((*after).*poses)[index],
                       (time - from) / (to - from));
}

}  // namespace synthetic_dataset::lidar

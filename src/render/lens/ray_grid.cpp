#include "render/lens/ray_grid.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace synthetic_dataset::render {

RayGrid makeRayGrid(const Intrinsics& intrinsics, const cv::Size& cells,
                    const std::vector<PlacedRay>& rays) {
  RayGrid grid{intrinsics, cells, {}, {}, {}, {}};
  const auto cellOf = [&](const PlacedRay& ray) {
    const int column = std::clamp(static_cast<int>(ray.column), 0, cells.width - 1);
    const int row = std::clamp(static_cast<int>(ray.row), 0, cells.height - 1);
    return static_cast<std::size_t>(row * cells.width + column);
  };
  grid.first.assign(static_cast<std::size_t>(cells.area()) + 1, 0);
  for (const PlacedRay& ray : rays) ++grid.first[cellOf(ray) + 1];
  for (std::size_t i = 1; i < grid.first.size(); ++i) grid.first[i] += grid.first[i - 1];
  constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();
  grid.columns.assign(rays.size() + RayGrid::kSpare, kNowhere);
  grid.rows.assign(rays.size() + RayGrid::kSpare, kNowhere);
  grid.rays.assign(rays.size(), 0);
  std::vector<int> next(grid.first.begin(), grid.first.end() - 1);
  for (const PlacedRay& ray : rays) {
    const auto i = static_cast<std::size_t>(next[cellOf(ray)]++);
    grid.columns[i] = ray.column;
    grid.rows[i] = ray.row;
    grid.rays[i] = ray.ray;
  }
  return grid;
}

}  // namespace synthetic_dataset::render

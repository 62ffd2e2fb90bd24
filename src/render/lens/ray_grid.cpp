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

void RowRayGrid::Bounds::extend(const Bounds& other) {
  left = std::min(left, other.left);
  top = std::min(top, other.top);
  right = std::max(right, other.right);
  bottom = std::max(bottom, other.bottom);
}

RowRayGrid makeRowRayGrid(const Intrinsics& intrinsics, const cv::Size& cells,
                          const std::vector<PlacedRay>& rays, int rows,
                          const std::function<int(int ray)>& row_of) {
  constexpr float kFar = std::numeric_limits<float>::infinity();
  RowRayGrid result{{intrinsics, cells, {}, {}, {}, {}}, {}};
  std::vector<std::vector<PlacedRay>> in_rows(static_cast<std::size_t>(rows));
  for (const PlacedRay& ray : rays) {
    in_rows[static_cast<std::size_t>(row_of(ray.ray))].push_back(ray);
  }
  RayGrid& grid = result.grid;
  for (std::vector<PlacedRay>& row : in_rows) {
    std::stable_sort(row.begin(), row.end(), [](const PlacedRay& one, const PlacedRay& other) {
      return one.column < other.column;
    });
    RowRayGrid::Bounds& bounds = result.rows.emplace_back();
    bounds = {kFar, kFar, -kFar, -kFar};
    grid.first.push_back(static_cast<int>(grid.rays.size()));
    for (const PlacedRay& ray : row) {
      bounds.extend({ray.column, ray.row, ray.column, ray.row});
      grid.columns.push_back(ray.column);
      grid.rows.push_back(ray.row);
      grid.rays.push_back(ray.ray);
    }
  }
  grid.first.push_back(static_cast<int>(grid.rays.size()));
  constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();
  grid.columns.resize(grid.rays.size() + RayGrid::kSpare, kNowhere);
  grid.rows.resize(grid.rays.size() + RayGrid::kSpare, kNowhere);
  return result;
}

}  // namespace synthetic_dataset::render

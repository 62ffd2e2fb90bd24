#include "randomize/placement/free_places.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace synthetic_dataset::randomize {
namespace {

/// The distance of each non-zero point to the nearest zero; 0 for zeros.
cv::Mat1f distancesToZeros(const cv::Mat1b& points) {
  cv::Mat1f distances;
  cv::distanceTransform(points, distances, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
  return distances;
}

/// 0 for cells that are not free, with a rim of such cells around the map.
cv::Mat1b freeCells(const OccupancyMap& map) {
  cv::Mat1b free(static_cast<int>(map.height()) + 2, static_cast<int>(map.width()) + 2, uchar{0});
  for (std::size_t row = 0; row < map.height(); ++row) {
    uchar* points = free.ptr(static_cast<int>(row) + 1) + 1;
    for (std::size_t column = 0; column < map.width(); ++column) {
      if (map.cell(column, row) == Cell::kFree) points[column] = 255;
    }
  }
  return free;
}

/// 0 at the corners, side midpoints and centres of the cells that are not free, and on the map's
/// rim: points half a cell apart.
cv::Mat1b freePoints(const OccupancyMap& map) {
  const cv::Size size(static_cast<int>(2 * map.width()) + 1,
                      static_cast<int>(2 * map.height()) + 1);
  cv::Mat1b free(size, uchar{255});
  cv::rectangle(free, cv::Rect(cv::Point(0, 0), size), cv::Scalar(0));
  for (std::size_t row = 0; row < map.height(); ++row) {
    for (std::size_t column = 0; column < map.width(); ++column) {
      if (map.cell(column, row) == Cell::kFree) continue;
      for (std::size_t y = 2 * row; y <= 2 * row + 2; ++y) {
        std::fill_n(free.ptr(static_cast<int>(y)) + 2 * column, 3, uchar{0});
      }
    }
  }
  return free;
}

/// The cells that may contain a clear place. No place in a cell is farther from another cell than
/// the two centres are apart: n columns and m rows away, its far corner (or far side, if n or m is
/// 0) is sqrt(n^2 + m^2) from the near one of the other cell.
std::vector<std::size_t> cellsThatMayBeClear(const OccupancyMap& map, double radius) {
  constexpr double kRounding = 1.0 + 1e-6;  // of the float distances
  const cv::Mat1f distances = distancesToZeros(freeCells(map));
  std::vector<std::size_t> cells;
  for (std::size_t row = 0; row < map.height(); ++row) {
    const float* to_others = distances[static_cast<int>(row) + 1] + 1;
    for (std::size_t column = 0; column < map.width(); ++column) {
      const bool is_free = to_others[column] > 0.0F;
      if (is_free && to_others[column] * kRounding >= radius) {
        cells.push_back(row * map.width() + column);
      }
    }
  }
  return cells;
}

}  // namespace

FreePlaces::FreePlaces(OccupancyMap map, double safety_radius)
    : map_(std::move(map)),
      radius_(safety_radius / map_.resolution()),
      cells_(cellsThatMayBeClear(map_, radius_)) {}

bool FreePlaces::isClear(const Eigen::Vector2d& p_G) const {
  return map_.isFree(p_G) && isDiscClear(map_.toMap(p_G) / map_.resolution());
}

std::optional<Eigen::Vector2d> FreePlaces::draw(base::RandomSource& random, int tries) const {
  if (cells_.empty()) return std::nullopt;
  for (int i = 0; i < tries; ++i) {
    const std::size_t cell = cells_[random.index(cells_.size())];
    const double x = static_cast<double>(cell % map_.width()) + random.unit();
    const double y = static_cast<double>(cell / map_.width()) + random.unit();
    if (isDiscClear({x, y})) return map_.toGlobal(Eigen::Vector2d(x, y) * map_.resolution());
  }
  return std::nullopt;
}

bool FreePlaces::isDiscClear(const Eigen::Vector2d& centre) const {
  const double x = centre.x();
  const double y = centre.y();
  const bool is_in_map = x >= radius_ && x + radius_ <= static_cast<double>(map_.width()) &&
                         y >= radius_ && y + radius_ <= static_cast<double>(map_.height());
  if (!is_in_map) return false;
  const auto end = std::min(map_.height(), static_cast<std::size_t>(std::ceil(y + radius_)));
  for (auto row = static_cast<std::size_t>(y - radius_); row < end; ++row) {
    const auto below = static_cast<double>(row);
    const double away = std::max({below - y, y - (below + 1.0), 0.0});
    if (away >= radius_) continue;
    // Where the disc is widest within the row.
    const double half = std::sqrt(radius_ * radius_ - away * away);
    if (!isRowFree(row, x - half, x + half)) return false;
  }
  return true;
}

bool FreePlaces::isRowFree(std::size_t row, double from, double to) const {
  const auto end = std::min(map_.width(), static_cast<std::size_t>(std::ceil(to)));
  for (auto column = static_cast<std::size_t>(from); column < end; ++column) {
    if (map_.cell(column, row) != Cell::kFree) return false;
  }
  return true;
}

double largestClearance(const OccupancyMap& map) {
  // With points half a cell apart, the place in a square nearest to any of them is one of them,
  // too.
  double half_cells = 0.0;
  cv::minMaxLoc(distancesToZeros(freePoints(map)), nullptr, &half_cells);
  return half_cells / 2.0 * map.resolution();
}

}  // namespace synthetic_dataset::randomize

#include "run/live/live_map.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "run/live/json_values.h"

namespace synthetic_dataset::run {
namespace {

cv::Vec3b inkOf(const std::optional<randomize::Cell>& cell) {
  if (cell == randomize::Cell::kFree) return {252, 252, 252};
  if (cell == randomize::Cell::kOccupied) return {70, 60, 60};
  return {190, 188, 186};
}

Eigen::AlignedBox2d extentOf(const randomize::OccupancyMap& map) {
  const double width = map.resolution() * static_cast<double>(map.width());
  const double height = map.resolution() * static_cast<double>(map.height());
  Eigen::AlignedBox2d extent;
  for (const double x : {0.0, width}) {
    for (const double y : {0.0, height}) extent.extend(map.toGlobal({x, y}));
  }
  return extent;
}

}  // namespace

Value extentValue(const Eigen::AlignedBox2d& extent) {
  return numbersValue({extent.min().x(), extent.min().y(), extent.max().x(), extent.max().y()});
}

LiveMap pictureOf(const randomize::OccupancyMap& map) {
  constexpr double kLongSide = 1100.0;  // [px]
  LiveMap result;
  result.extent = extentOf(map);
  const Eigen::Vector2d size = result.extent.sizes();
  const double pixel = std::max(size.maxCoeff() / kLongSide, map.resolution() / 4.0);  // [m]
  const int columns = std::max(1, static_cast<int>(std::lround(size.x() / pixel)));
  const int rows = std::max(1, static_cast<int>(std::lround(size.y() / pixel)));
  result.picture.create(rows, columns, CV_8UC3);
  for (int row = 0; row < rows; ++row) {
    const double y = result.extent.max().y() - (row + 0.5) * size.y() / rows;
    for (int column = 0; column < columns; ++column) {
      const double x = result.extent.min().x() + (column + 0.5) * size.x() / columns;
      result.picture.at<cv::Vec3b>(row, column) = inkOf(map.cellAt({x, y}));
    }
  }
  return result;
}

}  // namespace synthetic_dataset::run

#include "plugins/readback/range_image.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace synthetic_dataset::formats {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// A point in the scanner's spherical coordinates.
struct Direction {
  double azimuth = 0.0;    ///< [rad]
  double elevation = 0.0;  ///< [rad]
  double range = 0.0;      ///< [m]
};

Direction directionOf(const Eigen::Vector3f& p_S) {
  const Eigen::Vector3d p = p_S.cast<double>();
  return {std::atan2(p.y(), p.x()), std::atan2(p.z(), std::hypot(p.x(), p.y())), p.norm()};
}

/// The row of each ring, the highest first.
std::vector<int> rowsOfRings(const LabelledCloud& cloud, const std::vector<Direction>& directions) {
  std::vector<std::pair<double, int>> sums;  // sum of elevations, and count
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const std::size_t ring = cloud.points[i].ring;
    if (ring >= sums.size()) sums.resize(ring + 1);
    sums[ring].first += directions[i].elevation;
    ++sums[ring].second;
  }
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t ring = 0; ring < sums.size(); ++ring) {
    if (sums[ring].second > 0) order.emplace_back(-sums[ring].first / sums[ring].second, ring);
  }
  std::sort(order.begin(), order.end());
  std::vector<int> rows(sums.size(), 0);
  for (std::size_t row = 0; row < order.size(); ++row) {
    rows[order[row].second] = static_cast<int>(row);
  }
  return rows;
}

/// The index of the point that each cell of the picture shows; -1 for none. Of several, the
/// nearest.
class Cells {
 public:
  Cells(const cv::Size& size, const std::vector<Direction>& directions)
      : nearest_(size, -1), directions_(directions) {}

  void add(int column, int row, int point) {
    if (column < 0 || row < 0 || column >= nearest_.cols || row >= nearest_.rows) return;
    int& cell = nearest_(row, column);
    if (cell < 0 || rangeOf(point) < rangeOf(cell)) cell = point;
  }

  [[nodiscard]] const cv::Mat_<int>& points() const { return nearest_; }

 private:
  [[nodiscard]] double rangeOf(int point) const {
    return directions_[static_cast<std::size_t>(point)].range;
  }

  cv::Mat_<int> nearest_;
  const std::vector<Direction>& directions_;
};

/// Fills empty cells with a neighbour's point, so that sparse rows are visible.
cv::Mat_<int> spread(const cv::Mat_<int>& cells, int columns, int rows) {
  cv::Mat_<int> result = cells.clone();
  for (int row = 0; row < cells.rows; ++row) {
    for (int column = 0; column < cells.cols; ++column) {
      if (cells(row, column) < 0) continue;
      for (int v = std::max(0, row - rows); v <= std::min(cells.rows - 1, row + rows); ++v) {
        for (int u = std::max(0, column - columns); u <= std::min(cells.cols - 1, column + columns);
             ++u) {
          if (result(v, u) < 0) result(v, u) = cells(row, column);
        }
      }
    }
  }
  return result;
}

/// The cells of a picture of the given size; also sets the range of azimuths in `images`.
cv::Mat_<int> cellsOf(const LabelledCloud& cloud, const std::vector<Direction>& directions,
                      const cv::Size& size, RangeImages& images) {
  double left = -kPi;
  double right = kPi;
  double low = kPi;
  double high = -kPi;
  for (const Direction& each : directions) {
    left = std::max(left, each.azimuth);
    right = std::min(right, each.azimuth);
    low = std::min(low, each.elevation);
    high = std::max(high, each.elevation);
  }
  constexpr double kWholeTurn = 1.95 * kPi;
  if (left - right > kWholeTurn) left = kPi, right = -kPi;
  images.left = left;
  images.right = right;
  const std::vector<int> rows =
      cloud.has_rings ? rowsOfRings(cloud, directions) : std::vector<int>();
  const int row_count =
      rows.empty() ? size.height : 1 + *std::max_element(rows.begin(), rows.end());
  Cells cells({size.width, std::min(row_count, size.height)}, directions);
  const auto place = [](double value, double first, double last, int count) {
    return last == first
               ? 0
               : static_cast<int>(std::lround((value - first) / (last - first) * (count - 1)));
  };
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const int height = cells.points().rows;
    const int row = rows.empty() ? place(directions[i].elevation, high, low, height)
                                 : rows[cloud.points[i].ring] * height / row_count;
    cells.add(place(directions[i].azimuth, left, right, size.width), row, static_cast<int>(i));
  }
  return cells.points();
}

cv::Vec3b vec(const cv::Scalar& colour) {
  return {cv::saturate_cast<uchar>(colour[0]), cv::saturate_cast<uchar>(colour[1]),
          cv::saturate_cast<uchar>(colour[2])};
}

}  // namespace

cv::Mat rangeScale(const cv::Size& size) {
  cv::Mat shades(size, CV_8UC1);
  for (int u = 0; u < size.width; ++u) {
    shades.col(u).setTo(cv::Scalar::all(255.0 - 225.0 * u / std::max(1, size.width - 1)));
  }
  cv::Mat colours;
  cv::applyColorMap(shades, colours, cv::COLORMAP_VIRIDIS);
  return colours;
}

RangeImages rangeImages(const LabelledCloud& cloud,
                        const std::map<std::uint16_t, ClassColour>& colours, const cv::Size& size) {
  RangeImages images;
  images.ranges = cv::Mat::zeros(size, CV_8UC3);
  images.labels = cv::Mat::zeros(size, CV_8UC3);
  if (cloud.points.empty()) return images;
  std::vector<Direction> directions;
  std::vector<double> ranges;
  for (const LabelledCloud::Point& point : cloud.points) {
    directions.push_back(directionOf(point.position_S));
    ranges.push_back(directions.back().range);
  }
  std::sort(ranges.begin(), ranges.end());
  constexpr double kLeast = 0.01;  // [m]
  images.nearest = std::max(ranges[ranges.size() / 100], kLeast);
  images.farthest = std::max(ranges[ranges.size() * 98 / 100], images.nearest + 0.1);
  cv::Mat_<int> cells = cellsOf(cloud, directions, size, images);
  const int gap_columns = size.width > 800 ? 1 : 0;  // scanners have about a thousand columns
  cells = spread(cells, gap_columns, cloud.has_rings ? 0 : 1);

  constexpr int kShades = 256;
  constexpr double kLightest = 125.0;  // for points without a class, which get darker with range
  const cv::Mat scale = rangeScale({kShades, 1});
  for (int v = 0; v < size.height; ++v) {
    const int row = v * cells.rows / size.height;
    for (int u = 0; u < size.width; ++u) {
      const int i = cells(row, u);
      if (i < 0) continue;
      const auto at = static_cast<std::size_t>(i);
      // On a logarithmic scale, which gives near ranges more contrast.
      const double share = std::log(std::max(directions[at].range, kLeast) / images.nearest) /
                           std::log(images.farthest / images.nearest);
      const int shade = static_cast<int>(std::clamp(share, 0.0, 1.0) * (kShades - 1));
      images.ranges.at<cv::Vec3b>(v, u) = scale.at<cv::Vec3b>(0, shade);
      const auto found = colours.find(cloud.points[at].number);
      images.labels.at<cv::Vec3b>(v, u) =
          vec(found == colours.end() ? cv::Scalar::all(kLightest * (1.0 - shade / 300.0))
                                     : found->second.colour);
    }
  }
  return images;
}

}  // namespace synthetic_dataset::formats

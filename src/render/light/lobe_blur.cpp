#include "render/light/lobe_blur.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <Eigen/Core>
#include <opencv2/core/hal/intrin.hpp>
#include <opencv2/imgproc.hpp>

#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {
namespace {

/// A part of the lobe; each has the same weight.
struct Cell {
  Eigen::Vector3d direction;  ///< the lobe's axis is z
  double size;                ///< the root of its solid angle [rad]
};

/// The angle from the lobe's axis within which such a share of the microfacets mirrors [rad]
/// (Walter et al. 2007).
double angleOfShare(double share, double alpha) {
  return 2.0 * std::atan(alpha * std::sqrt(share / (1.0 - share)));
}

/// The angles from the axis that cut the lobe into so many rings of equal weight; the first is 0,
/// the last a right angle.
std::vector<double> ringsOf(double alpha, int count) {
  constexpr int kPlaces = 4096;
  // Beyond a right angle, light would come from below the surface.
  const double most = 1.0 / (1.0 + alpha * alpha);
  std::vector<double> within(1, 0.0);
  for (int i = 0; i < kPlaces; ++i) {
    const double angle = angleOfShare(most * (i + 0.5) / kPlaces, alpha);
    within.push_back(within.back() + std::max(0.0, std::cos(angle)));
  }
  std::vector<double> angles;
  for (int ring = 0; ring <= count; ++ring) {
    const double wanted = within.back() * ring / count;
    const auto next = std::lower_bound(within.begin(), within.end(), wanted);
    const auto step = static_cast<double>(next - within.begin());
    angles.push_back(angleOfShare(most * std::min(1.0, step / kPlaces), alpha));
  }
  return angles;
}

std::vector<Cell> cellsOf(double alpha, int rings, int sectors) {
  const std::vector<double> bounds = ringsOf(alpha, 2 * rings);
  std::vector<Cell> cells;
  for (int ring = 0; ring < rings; ++ring) {
    const auto first = static_cast<std::size_t>(2 * ring);
    const double angle = bounds[first + 1];
    const double solid_angle = 2.0 * M_PI * (std::cos(bounds[first]) - std::cos(bounds[first + 2]));
    for (int sector = 0; sector < sectors; ++sector) {
      const double around = 2.0 * M_PI * (sector + 0.5 * (ring % 2)) / sectors;
      cells.push_back({{std::sin(angle) * std::cos(around), std::sin(angle) * std::sin(around),
                        std::cos(angle)},
                       std::sqrt(solid_angle / sectors)});
    }
  }
  return cells;
}

/// The copy whose pixels are about as large as a cell.
std::size_t copyFor(const Cell& cell, const std::vector<cv::Mat>& smaller) {
  const double pixels = cell.size / (M_PI / smaller.front().rows);
  const auto halvings = std::lround(std::log2(std::max(pixels, 1.0)));
  return std::min(static_cast<std::size_t>(halvings), smaller.size() - 1);
}

/// Adds what one cell sees from all places of a row, at which the lobe's axis goes around.
/// @param row, column  of the panorama's, of the cell of the first place [px]
void addCell(const cv::Mat& panorama, double row, double column, std::vector<Lanes>& sums) {
  const double y = std::clamp(row, 0.0, panorama.rows - 1.0);
  const int upper_row = static_cast<int>(y);
  const float down = static_cast<float>(y - upper_row);
  const auto* upper = panorama.ptr<float>(upper_row);
  const auto* lower = panorama.ptr<float>(std::min(upper_row + 1, panorama.rows - 1));
  const Lanes of_lower = lanes(down);
  const Lanes of_upper = lanes(1.0F - down);
  const auto seen = [&](int at) {
    const std::ptrdiff_t place = std::ptrdiff_t{4} * at;
    return cv::v_load(upper + place) * of_upper + cv::v_load(lower + place) * of_lower;
  };
  const double step = static_cast<double>(panorama.cols) / static_cast<double>(sums.size());
  double x = column - panorama.cols * std::floor(column / panorama.cols);
  for (Lanes& sum : sums) {
    if (x >= panorama.cols) x -= panorama.cols;
    const int left = static_cast<int>(x);
    const int right = left + 1 < panorama.cols ? left + 1 : 0;
    const auto share = static_cast<float>(x - left);
    sum += seen(left) * lanes(1.0F - share) + seen(right) * lanes(share);
    x += step;
  }
}

}  // namespace

std::vector<cv::Mat> smallerPanoramas(const cv::Mat& panorama) {
  std::vector<cv::Mat> copies = {panorama};
  while (copies.back().rows >= 8) {
    const cv::Size half(copies.back().cols / 2, copies.back().rows / 2);
    cv::Mat smaller;
    cv::resize(copies.back(), smaller, half, 0.0, 0.0, cv::INTER_AREA);
    copies.push_back(smaller);
  }
  return copies;
}

cv::Mat blurredByLobe(const std::vector<cv::Mat>& smaller, double alpha, int rows) {
  // The sharper, the more pixels there are and the less matters what is beside the lobe.
  const int rings = rows > 128 ? 8 : 12;
  const int sectors = rows > 128 ? 8 : 16;
  const std::vector<Cell> cells = cellsOf(alpha, rings, sectors);
  cv::Mat blurred(rows, 2 * rows, CV_32FC4);
  std::vector<Lanes> sums(static_cast<std::size_t>(blurred.cols));
  for (int row = 0; row < rows; ++row) {
    std::fill(sums.begin(), sums.end(), lanes(0.0F));
    const double elevation = M_PI * (0.5 - (row + 0.5) / rows);
    const Eigen::Vector3d axis(std::cos(elevation), 0.0, std::sin(elevation));
    const Eigen::Vector3d up(-std::sin(elevation), 0.0, std::cos(elevation));
    for (const Cell& cell : cells) {
      const Eigen::Vector3d way = cell.direction.z() * axis + cell.direction.y() * up +
                                  cell.direction.x() * Eigen::Vector3d::UnitY();
      const cv::Mat& copy = smaller[copyFor(cell, smaller)];
      const double height = std::asin(std::clamp(way.z(), -1.0, 1.0));
      // To the right is where the azimuth falls.
      const double turn = -std::atan2(way.y(), way.x()) / (2.0 * M_PI);
      addCell(copy, (0.5 - height / M_PI) * copy.rows - 0.5,
              (0.5 / blurred.cols + turn) * copy.cols - 0.5, sums);
    }
    const Lanes each = lanes(1.0F / static_cast<float>(cells.size()));
    for (int column = 0; column < blurred.cols; ++column) {
      cv::v_store(blurred.ptr<float>(row, column), sums[static_cast<std::size_t>(column)] * each);
    }
  }
  return blurred;
}

}  // namespace synthetic_dataset::render

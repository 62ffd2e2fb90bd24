#include "render/light/panorama_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core/hal/intrin.hpp>
#include <opencv2/core/mat.hpp>
#include <opencv2/imgproc.hpp>

#include "render/light/panorama_lookup.h"
#include "render/pixels/lanes.h"
#include "render/pixels/light_picture.h"

namespace synthetic_dataset::render {
namespace {

/// A part of the lobe; all parts have the same weight.
struct Cell {
  Eigen::Vector3d direction;  ///< the lobe's axis is z
  double size;                ///< the square root of its solid angle [rad]
};

/// The angle from the lobe's axis within which a given share of the microfacets reflects [rad]
/// (Walter et al. 2007).
double angleOfShare(double share, double alpha) {
  return 2.0 * std::atan(alpha * std::sqrt(share / (1.0 - share)));
}

/// The angles from the axis that cut the lobe into rings of equal weight; the first is 0,
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

/// The index of the copy whose pixels are about as large as a cell.
std::size_t copyFor(const Cell& cell, const std::vector<cv::Mat>& smaller) {
  const double pixels = cell.size / (M_PI / smaller.front().rows);
  const auto halvings = std::lround(std::log2(std::max(pixels, 1.0)));
  return std::min(static_cast<std::size_t>(halvings), smaller.size() - 1);
}

/// Adds what one cell sees for all directions of the lobe's axis in a row of the result.
/// @param row, column  where the cell is in the panorama for the first of these directions [px]
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

/// Ever smaller copies of a panorama, each half as wide and high as the one before, whose pixels
/// are means of what they cover.
/// @param panorama  CV_32FC4: equirectangular, linear
/// @return the copies, beginning with the panorama itself
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

/// What a rough surface reflects of a panorama, for each mirror direction: the mean over the GGX
/// lobe, weighted by the cosine, for a surface that is viewed head-on (Karis 2013, "Real Shading in
/// Unreal Engine 4"). The lobe is cut into rings of equal weight and these into cells, each of
/// which is looked up in the copy whose pixels are about as large (after Krivanek and Colbert 2008,
/// "Real-time Shading with Filtered Importance Sampling", but with places that are not random).
/// @param smaller  from smallerPanoramas()
/// @param alpha  of GGX: the square of the roughness, > 0
/// @return CV_32FC4: equirectangular, too, twice as wide as high
cv::Mat blurredByLobe(const std::vector<cv::Mat>& smaller, double alpha, int rows) {
  // The sharper the lobe, the more pixels there are, and the less its outer part matters.
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
      // The azimuth decreases to the right.
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

/// GGX's alpha for each level: a mirror, the same picture with fewer pixels, and blurred ones.
constexpr std::array<float, 9> kAlphas = {0.0F,     1.0F / 256, 1.0F / 64, 1.0F / 32, 1.0F / 16,
                                          1.0F / 8, 1.0F / 4,   1.0F / 2,  1.0F};
constexpr std::size_t kFirstBlurred = 2;

constexpr int kMatteRows = 64;  // of the copy whose pixels are all summed up

/// The number of rows of a level: at least two pixels for the width of its lobe.
int rowsOf(std::size_t level) {
  constexpr int kSharpest = 256;
  constexpr int kLeast = 32;
  return std::max(kSharpest >> (level - kFirstBlurred), kLeast);
}

/// @param panorama  CV_32FC4
/// @return a copy so small that summing up all its pixels is fast
cv::Mat reduced(const cv::Mat& panorama) {
  cv::Mat light;
  cv::resize(panorama, light, {2 * kMatteRows, kMatteRows}, 0.0, 0.0, cv::INTER_AREA);
  return light;
}

/// @param panorama  CV_16UC4 @return CV_32FC4
cv::Mat toFloats(const cv::Mat& panorama) {
  cv::Mat floats(panorama.size(), CV_32FC4);
  for (int row = 0; row < panorama.rows; ++row) {
    const auto* from = panorama.ptr<std::uint16_t>(row);
    auto* to = floats.ptr<float>(row);
    for (int i = 0; i < 4 * panorama.cols; i += kLaneCount) {
      cv::v_store(to + i, fromHalf(cv::v_load_expand(from + i)));
    }
  }
  return floats;
}

/// @param panorama  CV_32FC4 @return CV_16UC4
cv::Mat toHalves(const cv::Mat& panorama) {
  constexpr float kMost = 65504.0F;
  cv::Mat halves(panorama.size(), CV_16UC4);
  for (int row = 0; row < panorama.rows; ++row) {
    const auto* from = panorama.ptr<float>(row);
    auto* to = halves.ptr<std::uint16_t>(row);
    for (int i = 0; i < 4 * panorama.cols; i += kLaneCount) {
      cv::v_pack_store(to + i, halfFrom(clamped(cv::v_load(from + i), 0.0F, kMost)));
    }
  }
  return halves;
}

/// @param panorama  CV_16UC4
/// @return CV_32FC4, at most 1024 pixels wide
cv::Mat smaller(const cv::Mat& panorama) {
  constexpr int kMostColumns = 1024;
  cv::Mat light = toFloats(panorama);
  if (light.cols > kMostColumns) {
    cv::resize(light, light, {kMostColumns, kMostColumns / 2}, 0.0, 0.0, cv::INTER_AREA);
  }
  return light;
}

/// The level of a lobe, with fractions between levels: an integer at each of kAlphas, and linear in
/// the logarithm between those that are not 0.
Lanes levelOf(const Lanes& roughness) {
  constexpr float kPerTwo = 1.44269504F;
  const Lanes alpha = roughness * roughness;
  const Lanes twos = logarithm(alpha) * lanes(kPerTwo);
  const Lanes sharp = alpha * lanes(256.0F);
  const Lanes between = lanes(5.0F) + lanes(0.5F) * twos;
  const Lanes blurred = lanes(8.0F) + twos;
  const Lanes level = cv::v_select(alpha < lanes(1.0F / 64), between, blurred);
  return clamped(cv::v_select(alpha < lanes(1.0F / 256), sharp, level), 0.0F,
                 kAlphas.size() - 1.0F);
}

/// What the levels show at four places.
/// @param which  the level for each place
Lanes3 shown(const std::vector<cv::Mat>& levels, const std::array<int, kLaneCount>& which,
             const PanoramaPlaces& places) {
  const auto level = [&](std::size_t lane) -> const cv::Mat& {
    return levels[static_cast<std::size_t>(which[lane])];
  };
  const auto load = [](const std::uint16_t* pixels) { return loadHalves(pixels).xyz; };
  return seenBetween<cv::Vec4w>(places, level, load);
}

}  // namespace

PanoramaLight::PanoramaLight(const cv::Mat& panorama)
    : PanoramaLight(panorama, smaller(panorama)) {}

PanoramaLight::PanoramaLight(const cv::Mat& panorama, const cv::Mat& light)
    : above_(reduced(light), 0, kMatteRows / 2),
      below_(reduced(light), kMatteRows / 2, kMatteRows),
      levels_{bordered(panorama), bordered(toHalves(light))} {
  const std::vector<cv::Mat> copies = smallerPanoramas(light);
  for (std::size_t level = kFirstBlurred; level < kAlphas.size(); ++level) {
    levels_.push_back(
        bordered(toHalves(blurredByLobe(copies, double{kAlphas[level]}, rowsOf(level)))));
  }
}

Lanes3 PanoramaLight::mirrored(const Lanes3& directions, const Lanes& roughness) const {
  const PanoramaPlaces places = placesOf(directions);
  const Lanes level = levelOf(roughness);
  const cv::v_int32x4 whole = cv::v_trunc(level);
  std::array<int, kLaneCount> which{};
  cv::v_store(which.data(), whole);
  const Lanes share = level - cv::v_cvt_f32(whole);
  const Lanes3 sharper = shown(levels_, which, places);
  if (cv::v_check_all(share == lanes(0.0F))) return sharper;
  for (int& each : which) each = std::min(each + 1, static_cast<int>(levels_.size()) - 1);
  return mix(sharper, shown(levels_, which, places), share);
}

std::size_t PanoramaLight::memory() const {
  std::size_t bytes = 0;
  for (const cv::Mat& level : levels_) bytes += level.total() * level.elemSize();
  return bytes;
}

cv::Mat panoramaOf(const world::Texture& picture) {
  constexpr int kMostColumns = 2048;
  cv::Mat light = toLight(picture.pixels, PixelMeaning::kColour);
  if (light.cols > kMostColumns) {
    cv::resize(light, light, {kMostColumns, kMostColumns / 2}, 0.0, 0.0, cv::INTER_AREA);
  }
  cv::Mat rgba;
  cv::cvtColor(light, rgba, cv::COLOR_BGRA2RGBA);
  if (rgba.depth() == CV_16U) rgba.convertTo(rgba, CV_32F, 1.0 / 65535.0);
  return toHalves(rgba);
}

}  // namespace synthetic_dataset::render

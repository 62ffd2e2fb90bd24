#include "render/weather/lens_dust.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>

#include "base/random/random_source.h"
#include "render/pixels/srgb.h"
#include "render/weather/cell_seed.h"
#include "render/weather/weather.h"

namespace synthetic_dataset::render {
namespace {

constexpr double kGlass = 0.02;          // [m] in front of the aperture
constexpr double kGlassCell = 0.01;      // [m] on the glass
constexpr double kSmallestSpeck = 1e-4;  // [m]
constexpr double kLargestSpeck = 1e-3;   // [m]
constexpr float kForwards = 0.5F;  // of the light on a speck, the share that goes on into the lens

struct Speck {
  Eigen::Vector2d place;  ///< on the glass, from the optical axis [m]
  double diameter;        ///< [m]
};

/// The mean area of specks whose widths are uniformly distributed on a logarithmic scale [m^2].
double meanArea() {
  return M_PI / 4.0 * (kLargestSpeck * kLargestSpeck - kSmallestSpeck * kSmallestSpeck) /
         (2.0 * std::log(kLargestSpeck / kSmallestSpeck));
}

/// The specks in a square of the glass. A larger share adds specks to those of a smaller one.
std::vector<Speck> specksIn(const Eigen::Vector2i& cell, const LensDust& dust) {
  base::RandomSource random(cellSeed(dust.seed, cell));
  const double expected = dust.share * kGlassCell * kGlassCell / meanArea();
  std::vector<Speck> specks;
  for (double count = 0.0;;) {
    count -= std::log(1.0 - random.unit());
    const double x = random.unit();  // one by one: the order of arguments is unspecified
    const double y = random.unit();
    const double size = random.unit();
    if (count >= expected) return specks;
    specks.push_back({kGlassCell * (cell.cast<double>() + Eigen::Vector2d(x, y)),
                      kSmallestSpeck * std::pow(kLargestSpeck / kSmallestSpeck, size)});
  }
}

/// Multiplies the light that arrives at pixels by the share that a speck lets pass.
/// @param scale  of the glass in the picture [px/m]
void drawSpeck(const Speck& speck, const Eigen::Array2d& axis, const Eigen::Array2d& scale,
               cv::Mat& passing) {
  const double mean_scale = scale.mean();
  const double rim = speck.diameter * mean_scale + 1.0;
  const double reach = 0.5 * (kLensAperture * mean_scale + rim);
  const double opacity = std::pow(speck.diameter / kLensAperture, 2.0);
  const Eigen::Array2d middle = axis + scale * speck.place.array();
  const Eigen::Array2d last(passing.cols - 1.0, passing.rows - 1.0);
  if ((middle + reach < 0.0).any() || (middle - reach > last).any()) return;
  const Eigen::Array2i first_pixel = (middle - reach).max(0.0).ceil().cast<int>();
  const Eigen::Array2i last_pixel = (middle + reach).min(last).floor().cast<int>();
  for (int v = first_pixel.y(); v <= last_pixel.y(); ++v) {
    auto* row = passing.ptr<float>(v);
    for (int u = first_pixel.x(); u <= last_pixel.x(); ++u) {
      const double away = std::hypot(u - middle.x(), v - middle.y());
      const double covered = std::clamp((reach - away) / rim, 0.0, 1.0);
      row[u] *= static_cast<float>(1.0 - opacity * covered);
    }
  }
}

/// The share of light that arrives at each pixel: CV_32FC1.
cv::Mat passingDust(const CameraModel& camera, const LensDust& dust) {
  const Intrinsics& k = camera.intrinsics();
  cv::Mat passing(camera.height(), camera.width(), CV_32FC1, cv::Scalar(1.0));
  const Eigen::Array2d axis(k.cx, k.cy);
  const Eigen::Array2d scale = Eigen::Array2d(k.fx, k.fy) / kGlass;
  const Eigen::Array2d size(camera.width(), camera.height());
  const double beside = 0.5 * (kLensAperture + kLargestSpeck);
  const Eigen::Array2i first = ((-axis / scale - beside) / kGlassCell).floor().cast<int>();
  const Eigen::Array2i last = (((size - axis) / scale + beside) / kGlassCell).floor().cast<int>();
  for (int y = first.y(); y <= last.y(); ++y) {
    for (int x = first.x(); x <= last.x(); ++x) {
      for (const Speck& speck : specksIn({x, y}, dust)) drawSpeck(speck, axis, scale, passing);
    }
  }
  return passing;
}

/// The mean light of a picture: blue, green, red.
cv::Vec3f meanLight(const cv::Mat& picture) {
  const auto& linear = linearFromSrgb();
  cv::Vec3d sum(0.0, 0.0, 0.0);
  for (int v = 0; v < picture.rows; ++v) {
    const auto* row = picture.ptr<cv::Vec3b>(v);
    for (int u = 0; u < picture.cols; ++u) {
      for (int c = 0; c < 3; ++c) sum[c] += double{linear[row[u][c]]};
    }
  }
  return sum * (1.0 / static_cast<double>(picture.total()));
}

}  // namespace

cv::Mat throughDust(const cv::Mat& picture, const CameraModel& camera, const LensDust& dust) {
  const cv::Mat passing = passingDust(camera, dust);
  const cv::Vec3f veil = kForwards * meanLight(picture);
  const auto& linear = linearFromSrgb();
  cv::Mat result = picture.clone();
  for (int v = 0; v < picture.rows; ++v) {
    const auto* shares = passing.ptr<float>(v);
    auto* pixels = result.ptr<cv::Vec3b>(v);
    for (int u = 0; u < picture.cols; ++u) {
      const float share = shares[u];
      if (share == 1.0F) continue;
      for (int c = 0; c < 3; ++c) {
        pixels[u][c] = srgbFromLinear(share * linear[pixels[u][c]] + (1.0F - share) * veil[c]);
      }
    }
  }
  return result;
}

}  // namespace synthetic_dataset::render

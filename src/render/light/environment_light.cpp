#include "render/light/environment_light.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

#include <opencv2/imgproc.hpp>

#include "render/pixels/light_picture.h"

namespace synthetic_dataset::render {
namespace {

/// Real spherical harmonics up to the second degree, without their constants.
template <class Number>
std::array<Number, 9> harmonics(const Number& one, const Number& x, const Number& y,
                                const Number& z) {
  return {one, y, z, x, x * y, y * z, z * z + z * z - x * x - y * y, x * z, x * x - y * y};
}

/// The square of each one's constant, times what is left of its degree behind a cosine (Ramamoorthi
/// and Hanrahan), over pi.
std::array<double, 9> shares() {
  const double first = 2.0 / 3.0 * 3.0 / (4.0 * M_PI);
  const double second = 1.0 / 4.0 * 15.0 / (4.0 * M_PI);
  return {1.0 / (4.0 * M_PI), first,  first,       first, second, second,
          second / 12.0,      second, second / 4.0};
}

}  // namespace

EnvironmentLight::EnvironmentLight(const world::BackgroundPicture& panorama) {
  constexpr int kRows = 64;
  constexpr int kColumns = 2 * kRows;
  cv::Mat light;
  cv::resize(toLight(panorama.picture->pixels, PixelMeaning::kColour), light, {kColumns, kRows},
             0.0, 0.0, cv::INTER_AREA);
  std::array<Eigen::Vector3d, 9> sums;
  sums.fill(Eigen::Vector3d::Zero());
  for (int row = 0; row < kRows; ++row) {
    const double elevation = M_PI * (0.5 - (row + 0.5) / kRows);
    const double solid_angle = std::cos(elevation) * (2.0 * M_PI / kColumns) * (M_PI / kRows);
    for (int column = 0; column < kColumns; ++column) {
      const double azimuth = panorama.yaw + 2.0 * M_PI * (0.5 - (column + 0.5) / kColumns);
      const auto& pixel = light.at<cv::Vec4w>(row, column);
      const Eigen::Vector3d colour =
          Eigen::Vector3d(pixel[2], pixel[1], pixel[0]) * (panorama.brightness / 65535.0);
      const auto terms = harmonics(1.0, std::cos(elevation) * std::cos(azimuth),
                                   std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
      for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += solid_angle * terms[i] * colour;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    factors_[i] = (shares()[i] * sums[i]).cast<float>();
  }
}

Lanes3 EnvironmentLight::arriving(const Lanes3& normals_G) const {
  const auto terms = harmonics(lanes(1.0F), normals_G.x, normals_G.y, normals_G.z);
  Lanes3 sum = lanes(0.0F, 0.0F, 0.0F);
  for (std::size_t i = 0; i < terms.size(); ++i) sum = sum + lanes(factors_[i]) * terms[i];
  const Lanes zero = lanes(0.0F);  // between what is bright and what is dark it may fall below
  return {cv::v_max(sum.x, zero), cv::v_max(sum.y, zero), cv::v_max(sum.z, zero)};
}

}  // namespace synthetic_dataset::render

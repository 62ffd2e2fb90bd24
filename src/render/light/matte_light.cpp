#include "render/light/matte_light.h"

#include <cmath>
#include <cstddef>

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

MatteLight::MatteLight(const cv::Mat& panorama, int first_row, int end_row) {
  std::array<Eigen::Vector3d, 9> sums;
  sums.fill(Eigen::Vector3d::Zero());
  const double row_angle = M_PI / panorama.rows;
  const double column_angle = 2.0 * M_PI / panorama.cols;
  for (int row = first_row; row < end_row; ++row) {
    const double elevation = 0.5 * M_PI - row_angle * (row + 0.5);
    const double solid_angle = std::cos(elevation) * column_angle * row_angle;
    for (int column = 0; column < panorama.cols; ++column) {
      const double azimuth = M_PI - column_angle * (column + 0.5);
      const auto& pixel = panorama.at<cv::Vec4f>(row, column);
      const Eigen::Vector3d colour(double{pixel[0]}, double{pixel[1]}, double{pixel[2]});
      const auto terms = harmonics(1.0, std::cos(elevation) * std::cos(azimuth),
                                   std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
      for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += solid_angle * terms[i] * colour;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    factors_[i] = (shares()[i] * sums[i]).cast<float>();
  }
}

Lanes3 MatteLight::arriving(const Lanes3& normals) const {
  const auto terms = harmonics(lanes(1.0F), normals.x, normals.y, normals.z);
  Lanes3 sum = lanes(0.0F, 0.0F, 0.0F);
  for (std::size_t i = 0; i < terms.size(); ++i) sum = sum + lanes(factors_[i]) * terms[i];
  const Lanes zero = lanes(0.0F);  // between what is bright and what is dark it may fall below
  return {cv::v_max(sum.x, zero), cv::v_max(sum.y, zero), cv::v_max(sum.z, zero)};
}

Eigen::Vector3f MatteLight::arriving(const Eigen::Vector3f& normal) const {
  const Lanes3 light = arriving(lanes(normal));
  return {light.x.get0(), light.y.get0(), light.z.get0()};
}

MatteLight MatteLight::sum(const MatteLight& first, const Eigen::Vector3f& of_first,
                           const MatteLight& second, const Eigen::Vector3f& of_second) {
  MatteLight all;
  for (std::size_t i = 0; i < all.factors_.size(); ++i) {
    all.factors_[i] =
        first.factors_[i].cwiseProduct(of_first) + second.factors_[i].cwiseProduct(of_second);
  }
  return all;
}

}  // namespace synthetic_dataset::render

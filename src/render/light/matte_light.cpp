#include "render/light/matte_light.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/core/hal/intrin.hpp>

#include "render/light/panorama_lookup.h"

namespace synthetic_dataset::render {
namespace {

constexpr int kRows = 32;  // of normals for which light is computed

/// The elevation of a panorama's row above the horizon [rad].
double elevationOf(double row, int rows) { return M_PI * (0.5 - row / rows); }

Eigen::Vector3f directionAt(int row, int column, const cv::Size& size) {
  const double elevation = elevationOf(row + 0.5, size.height);
  const double azimuth = M_PI * (1.0 - 2.0 * (column + 0.5) / size.width);
  return Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                         std::cos(elevation) * std::sin(azimuth), std::sin(elevation))
      .cast<float>();
}

/// Four pixels of a panorama, as light sources.
struct FourLights {
  Lanes3 directions;
  Lanes3 light;  ///< that arrives at a surface facing them
};

std::vector<FourLights> lightsOf(const cv::Mat& panorama, int first_row, int end_row) {
  std::vector<FourLights> lights;
  for (int row = first_row; row < end_row; ++row) {
    const double height =
        std::sin(elevationOf(row, panorama.rows)) - std::sin(elevationOf(row + 1, panorama.rows));
    // A pixel's solid angle divided by pi, which is what a white sky sums up to.
    const auto share = static_cast<float>(height * 2.0 / panorama.cols);
    for (int column = 0; column < panorama.cols; column += kLaneCount) {
      alignas(16) std::array<std::array<float, kLaneCount>, 3> direction{};
      for (int i = 0; i < kLaneCount; ++i) {
        const Eigen::Vector3f one = directionAt(row, column + i, panorama.size());
        for (std::size_t axis = 0; axis < 3; ++axis) {
          direction[axis][static_cast<std::size_t>(i)] = one[static_cast<Eigen::Index>(axis)];
        }
      }
      FourLights four{{cv::v_load(direction[0].data()), cv::v_load(direction[1].data()),
                       cv::v_load(direction[2].data())},
                      {}};
      Lanes other;
      cv::v_load_deinterleave(panorama.ptr<float>(row, column), four.light.x, four.light.y,
                              four.light.z, other);
      four.light = four.light * lanes(share);
      lights.push_back(four);
    }
  }
  return lights;
}

cv::Vec4f sumOf(const std::vector<FourLights>& lights, const Eigen::Vector3f& normal) {
  const Lanes3 n = lanes(normal);
  Lanes3 sum = lanes(0.0F, 0.0F, 0.0F);
  for (const FourLights& four : lights) {
    sum = sum + four.light * cv::v_max(dot(four.directions, n), lanes(0.0F));
  }
  // OpenCV's own sum of lanes adds in an order that depends on the processor.
  const auto all = [](const Lanes& four) {
    alignas(16) std::array<float, kLaneCount> each{};
    cv::v_store(each.data(), four);
    return each[0] + each[1] + each[2] + each[3];
  };
  return {all(sum.x), all(sum.y), all(sum.z), 0.0F};
}

}  // namespace

MatteLight::MatteLight(const cv::Mat& panorama, int first_row, int end_row) {
  const std::vector<FourLights> lights = lightsOf(panorama, first_row, end_row);
  cv::Mat map(kRows, 2 * kRows, CV_32FC4);
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.cols; ++column) {
      map.at<cv::Vec4f>(row, column) = sumOf(lights, directionAt(row, column, map.size()));
    }
  }
  map_ = bordered(map);
}

Lanes3 MatteLight::arriving(const Lanes3& normals) const {
  const auto load = [](const float* pixels) {
    Lanes3 four;
    Lanes other;
    cv::v_load_deinterleave(pixels, four.x, four.y, four.z, other);
    return four;
  };
  const auto map = [&](std::size_t) -> const cv::Mat& { return map_; };
  return seenBetween<cv::Vec4f>(placesOf(normals), map, load);
}

Eigen::Vector3f MatteLight::arriving(const Eigen::Vector3f& normal) const {
  const Lanes3 light = arriving(lanes(normal));
  return {light.x.get0(), light.y.get0(), light.z.get0()};
}

MatteLight MatteLight::sum(const MatteLight& first, const Eigen::Vector3f& of_first,
                           const MatteLight& second, const Eigen::Vector3f& of_second) {
  const auto times = [](const MatteLight& one, const Eigen::Vector3f& factor) {
    cv::Mat product;
    cv::multiply(one.map_, cv::Scalar(double{factor.x()}, double{factor.y()}, double{factor.z()}),
                 product);
    return product;
  };
  MatteLight all;
  all.map_ = times(first, of_first) + times(second, of_second);
  return all;
}

}  // namespace synthetic_dataset::render

#include "render/light/panorama_lookup.h"

#include <cmath>

#include <opencv2/core/hal/intrin.hpp>

#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {
namespace {

/// The angle of each (x, y) from the x axis, -pi .. pi, with an error of 3e-7; 0 for (0, 0)
/// (Cephes, atanf).
Lanes angleOf(const Lanes& y, const Lanes& x) {
  constexpr auto kPi = static_cast<float>(M_PI);
  constexpr float kTangentOfEighth = 0.414213562F;
  const Lanes zero = lanes(0.0F);
  const Lanes one = lanes(1.0F);
  const Lanes across = cv::v_abs(x);
  const Lanes up = cv::v_abs(y);
  // The slope relative to the nearer axis, 0 .. 1.
  const Lanes slope = cv::v_min(across, up) / cv::v_max(cv::v_max(across, up), lanes(1e-30F));
  const Lanes is_steep = slope > lanes(kTangentOfEighth);
  const Lanes s = cv::v_select(is_steep, (slope - one) / (slope + one), slope);
  const Lanes square = s * s;
  Lanes sum = lanes(8.05374449538e-2F);
  for (const float coefficient : {-1.38776856032e-1F, 1.99777106478e-1F, -3.33329491539e-1F}) {
    sum = sum * square + lanes(coefficient);
  }
  Lanes angle = sum * square * s + s + (lanes(kPi / 4.0F) & is_steep);
  angle = cv::v_select(up > across, lanes(kPi / 2.0F) - angle, angle);
  angle = cv::v_select(x < zero, lanes(kPi) - angle, angle);
  return cv::v_select(y < zero, zero - angle, angle);
}

}  // namespace

PanoramaPlaces placesOf(const Lanes3& directions) {
  constexpr auto kTurn = static_cast<float>(2.0 * M_PI);
  const Lanes half = lanes(0.5F);
  const Lanes level_sides = cv::v_sqrt(directions.x * directions.x + directions.y * directions.y);
  return {clamped(half - angleOf(directions.y, directions.x) * lanes(1.0F / kTurn), 0.0F, 1.0F),
          clamped(half - angleOf(directions.z, level_sides) * lanes(2.0F / kTurn), 0.0F, 1.0F)};
}

cv::Mat bordered(const cv::Mat& panorama) {
  const cv::Size size = panorama.size();
  cv::Mat all(size.height + 2, size.width + 2, panorama.type());
  panorama.copyTo(all({1, 1, size.width, size.height}));
  const int half = size.width / 2;
  for (const int row : {0, size.height + 1}) {
    const cv::Mat pole = panorama.row(row == 0 ? 0 : size.height - 1);
    cv::Mat beyond = all({1, row, size.width, 1});
    pole.colRange(half, size.width).copyTo(beyond.colRange(0, size.width - half));
    pole.colRange(0, half).copyTo(beyond.colRange(size.width - half, size.width));
  }
  all.col(size.width).copyTo(all.col(0));
  all.col(1).copyTo(all.col(size.width + 1));
  return all;
}

}  // namespace synthetic_dataset::render

#pragma once

#include <cmath>

#include <opencv2/core/hal/intrin.hpp>

#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {

/// The angle of each (x, y) from the x axis, -pi .. pi, to 3e-7; 0 for (0, 0) (Cephes, atanf).
[[nodiscard]] inline Lanes angleOf(const Lanes& y, const Lanes& x) {
  constexpr auto kPi = static_cast<float>(M_PI);
  constexpr float kTangentOfEighth = 0.414213562F;
  const Lanes zero = lanes(0.0F);
  const Lanes one = lanes(1.0F);
  const Lanes across = cv::v_abs(x);
  const Lanes up = cv::v_abs(y);
  // The slope of the nearer axis' side of the diagonal, 0 .. 1.
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

}  // namespace synthetic_dataset::render

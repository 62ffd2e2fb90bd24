#include "render/sensor/white_balance.h"

#include "render/sensor/sensor_options.h"

namespace synthetic_dataset::render {
namespace {

/// Linear sRGB (red, green, blue) of a black body, up to a factor. The Planckian locus in CIE 1931
/// x and y is the approximation of Kim et al., US patent 7024034 (2006), for 1667 to 25000 K; the
/// matrix is that of IEC 61966-2-1.
cv::Vec3d blackBody(double kelvin) {
  const double t = 1000.0 / kelvin;
  const double x = kelvin <= 4000.0 ? ((-0.2661239 * t - 0.2343589) * t + 0.8776956) * t + 0.179910
                                    : ((-3.0258469 * t + 2.1070379) * t + 0.2226347) * t + 0.240390;
  double y = 0.0;
  if (kelvin <= 2222.0) {
    y = ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683;
  } else if (kelvin <= 4000.0) {
    y = ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867;
  } else {
    y = ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
  }
  const double X = x / y;
  const double Z = (1.0 - x - y) / y;
  return {3.2406 * X - 1.5372 - 0.4986 * Z, -0.9689 * X + 1.8758 + 0.0415 * Z,
          0.0557 * X - 0.2040 + 1.0570 * Z};
}

}  // namespace

cv::Vec3f whiteBalanceGains(double kelvin) {
  const cv::Vec3d set = blackBody(kelvin);
  const cv::Vec3d neutral = blackBody(kNeutralWhite);
  const cv::Vec3d gains(neutral[0] / set[0], neutral[1] / set[1], neutral[2] / set[2]);
  const double luminance = 0.2126 * gains[0] + 0.7152 * gains[1] + 0.0722 * gains[2];
  const cv::Vec3d kept = gains / luminance;
  return {static_cast<float>(kept[2]), static_cast<float>(kept[1]), static_cast<float>(kept[0])};
}

}  // namespace synthetic_dataset::render

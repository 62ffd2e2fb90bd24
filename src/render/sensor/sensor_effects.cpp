#include "render/sensor/sensor_effects.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/random/random_seed.h"
#include "render/pixels/srgb.h"
#include "render/sensor/white_balance.h"

namespace synthetic_dataset::render {
namespace {

// Each pixel has several places in the random sequence: two for each kind of noise.
constexpr std::uint64_t kDrawsAPixel = 4;
constexpr std::uint64_t kShotNoise = 0;
constexpr std::uint64_t kReadNoise = 2;

cv::Mat toLinear(const cv::Mat& picture) {
  const auto& linear = linearFromSrgb();
  cv::Mat light(picture.size(), CV_32FC3);
  for (int v = 0; v < light.rows; ++v) {
    for (int u = 0; u < light.cols; ++u) {
      const cv::Vec3b& from = picture.at<cv::Vec3b>(v, u);
      light.at<cv::Vec3f>(v, u) = {linear[from[0]], linear[from[1]], linear[from[2]]};
    }
  }
  return light;
}

cv::Mat toSrgb(const cv::Mat& light) {
  cv::Mat picture(light.size(), CV_8UC3);
  for (int v = 0; v < light.rows; ++v) {
    for (int u = 0; u < light.cols; ++u) {
      const cv::Vec3f& from = light.at<cv::Vec3f>(v, u);
      picture.at<cv::Vec3b>(v, u) = {srgbFromLinear(from[0]), srgbFromLinear(from[1]),
                                     srgbFromLinear(from[2])};
    }
  }
  return picture;
}

std::uint64_t placeOf(int u, int v, const cv::Mat& picture) {
  return (static_cast<std::uint64_t>(v) * static_cast<std::uint64_t>(picture.cols) +
          static_cast<std::uint64_t>(u)) *
         kDrawsAPixel;
}

/// A normally distributed number for each of a pixel's channels.
cv::Vec3d drawChannels(std::uint64_t seed, std::uint64_t place) {
  const base::NormalPair a = base::randomNormals(seed, place);
  const base::NormalPair b = base::randomNormals(seed, place + 1);
  return {a.first, a.second, b.first};
}

/// Makes light fall off with the square of the distance from the image's middle, to 1 - strength in
/// the corners.
void vignette(double strength, cv::Mat& light) {
  const double u0 = 0.5 * (light.cols - 1);
  const double v0 = 0.5 * (light.rows - 1);
  const double corner = std::max(u0 * u0 + v0 * v0, 1e-9);
  for (int v = 0; v < light.rows; ++v) {
    for (int u = 0; u < light.cols; ++u) {
      const double r2 = ((u - u0) * (u - u0) + (v - v0) * (v - v0)) / corner;
      light.at<cv::Vec3f>(v, u) *= static_cast<float>(1.0 - strength * r2);
    }
  }
}

void balance(double kelvin, cv::Mat& light) {
  const cv::Vec3f gains = whiteBalanceGains(kelvin);
  cv::multiply(light, cv::Scalar(gains[0], gains[1], gains[2]), light);
}

/// Adds noise to the number of electrons, which is Poisson-distributed: for more than a handful,
/// approximately normal with a variance equal to its mean.
void addShotNoise(double full_well, std::uint64_t seed, cv::Mat& light) {
  for (int v = 0; v < light.rows; ++v) {
    for (int u = 0; u < light.cols; ++u) {
      const cv::Vec3d normal = drawChannels(seed, placeOf(u, v, light) + kShotNoise);
      cv::Vec3f& pixel = light.at<cv::Vec3f>(v, u);
      for (int channel = 0; channel < 3; ++channel) {
        const double electrons = full_well * pixel[channel];
        const double counted = electrons + std::sqrt(std::max(electrons, 0.0)) * normal[channel];
        pixel[channel] = static_cast<float>(std::max(std::round(counted), 0.0) / full_well);
      }
    }
  }
}

cv::Mat withReadNoise(const cv::Mat& picture, const SensorEffects& effects, std::uint64_t seed) {
  constexpr double kFullScale = 255.0;
  cv::Mat noisy(picture.size(), CV_8UC3);
  for (int v = 0; v < noisy.rows; ++v) {
    for (int u = 0; u < noisy.cols; ++u) {
      const cv::Vec3d normal = drawChannels(seed, placeOf(u, v, noisy) + kReadNoise);
      const cv::Vec3b& from = picture.at<cv::Vec3b>(v, u);
      for (int channel = 0; channel < 3; ++channel) {
        const double noise = effects.noise_mean + effects.noise_stddev * normal[channel];
        noisy.at<cv::Vec3b>(v, u)[channel] =
            cv::saturate_cast<unsigned char>(from[channel] + kFullScale * noise);
      }
    }
  }
  return noisy;
}

/// The picture after JPEG compression and decompression.
cv::Mat compressed(const cv::Mat& picture, int quality) {
  std::vector<unsigned char> file;
  cv::imencode(".jpg", picture, file, {cv::IMWRITE_JPEG_QUALITY, quality});
  return cv::imdecode(file, cv::IMREAD_COLOR);
}

}  // namespace

double gainOf(const SensorEffects& effects) { return std::exp2(effects.exposure); }

cv::Mat applyEffects(const cv::Mat& picture, const SensorEffects& effects, std::uint64_t seed) {
  cv::Mat result = picture;
  const bool is_tinted = effects.white_balance != kNeutralWhite;
  if (effects.blur > 0.0 || effects.vignetting > 0.0 || effects.full_well > 0.0 || is_tinted) {
    cv::Mat light = toLinear(picture);
    if (effects.blur > 0.0) {
      cv::GaussianBlur(light, light, cv::Size(), effects.blur, effects.blur, cv::BORDER_REPLICATE);
    }
    if (effects.vignetting > 0.0) vignette(effects.vignetting, light);
    if (effects.full_well > 0.0) addShotNoise(effects.full_well, seed, light);
    if (is_tinted) balance(effects.white_balance, light);
    result = toSrgb(light);
  }
  if (effects.noise_mean != 0.0 || effects.noise_stddev > 0.0) {
    result = withReadNoise(result, effects, seed);
  }
  if (effects.jpeg_quality > 0) result = compressed(result, effects.jpeg_quality);
  return result;
}

}  // namespace synthetic_dataset::render

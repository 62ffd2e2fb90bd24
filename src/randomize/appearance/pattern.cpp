#include "randomize/appearance/pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::randomize {
namespace {

constexpr int kSide = 256;  // [px]
constexpr double kTwoPi = 6.283185307179586;

/// The share of the second colour, 0 .. 1, at a place in the unit square, which repeats.
using Mixture = std::function<double(double u, double v)>;

cv::Vec4b drawColour(base::RandomSource& random) {
  const auto channel = [&] { return static_cast<std::uint8_t>(random.index(256)); };
  const std::uint8_t blue = channel();
  const std::uint8_t green = channel();
  return {blue, green, channel(), 255};
}

/// 1 inside, 0 outside, with a transition one pixel wide; distance to the border [of the square].
double edge(double distance) { return std::clamp(0.5 - distance * kSide, 0.0, 1.0); }

Mixture checkers(base::RandomSource& random) {
  const auto count = static_cast<double>(2 * (1 + random.index(8)));
  return [=](double u, double v) {
    const double product = std::sin(0.5 * kTwoPi * count * u) * std::sin(0.5 * kTwoPi * count * v);
    return product > 0.0 ? 1.0 : 0.0;
  };
}

Mixture stripes(base::RandomSource& random) {
  const auto across = static_cast<double>(1 + random.index(12));
  const auto along = static_cast<double>(random.index(7)) - 3.0;
  const double share = random.uniform(0.2, 0.8);
  return [=](double u, double v) {
    const double phase = across * u + along * v;
    return phase - std::floor(phase) < share ? 1.0 : 0.0;
  };
}

Mixture dots(base::RandomSource& random) {
  const auto count = static_cast<double>(2 + random.index(10));
  const double radius = random.uniform(0.15, 0.45);
  return [=](double u, double v) {
    const double x = count * u - std::floor(count * u) - 0.5;
    const double y = count * v - std::floor(count * v) - 0.5;
    return edge((std::hypot(x, y) - radius) / count);
  };
}

Mixture gradient(base::RandomSource& random) {
  const double phase = random.unit();
  const auto along = static_cast<double>(random.index(2));
  return [=](double u, double v) {
    return 0.5 + 0.5 * std::sin(kTwoPi * (along * u + (1.0 - along) * v + phase));
  };
}

/// A wave that repeats, stored as sines and cosines along each axis: the sine of the sum of two
/// angles follows from those of each.
struct Wave {
  Wave(double across, double along, double phase, double height) {
    for (int i = 0; i < kSide; ++i) {
      const double place = (i + 0.5) / kSide;
      const double x = kTwoPi * (across * place + phase);
      const double y = kTwoPi * along * place;
      columns[static_cast<std::size_t>(i)] = {height * std::sin(x), height * std::cos(x)};
      rows[static_cast<std::size_t>(i)] = {std::cos(y), std::sin(y)};
    }
  }

  [[nodiscard]] double at(std::size_t column, std::size_t row) const {
    return columns[column][0] * rows[row][0] + columns[column][1] * rows[row][1];
  }

  std::array<std::array<double, 2>, kSide> columns;
  std::array<std::array<double, 2>, kSide> rows;
};

/// Waves in many directions, fainter the finer they are: they repeat, and look like clouds.
Mixture clouds(base::RandomSource& random) {
  std::vector<Wave> waves;
  for (int i = 0; i < 24; ++i) {
    const double across = std::round(random.uniform(-9.0, 9.0));
    const double along = std::round(random.uniform(-9.0, 9.0));
    const double length = std::hypot(across, along);
    if (length > 0.0) waves.emplace_back(across, along, random.unit(), 1.0 / length);
  }
  return [=](double u, double v) {
    const auto column = static_cast<std::size_t>(u * kSide);
    const auto row = static_cast<std::size_t>(v * kSide);
    double sum = 0.0;
    for (const Wave& wave : waves) sum += wave.at(column, row);
    return std::clamp(0.5 + 0.35 * sum, 0.0, 1.0);
  };
}

cv::Mat painted(const Mixture& mixture, const cv::Vec4b& first, const cv::Vec4b& second) {
  cv::Mat picture(kSide, kSide, CV_8UC4);
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const double share = mixture((column + 0.5) / kSide, (row + 0.5) / kSide);
      cv::Vec4b& pixel = picture.at<cv::Vec4b>(row, column);
      for (int i = 0; i < 4; ++i) {
        pixel[i] = cv::saturate_cast<std::uint8_t>((1.0 - share) * first[i] + share * second[i]);
      }
    }
  }
  return picture;
}

}  // namespace

std::pair<std::string, std::shared_ptr<const world::Texture>> drawPattern(
    base::RandomSource& random) {
  struct Kind {
    const char* name;
    Mixture (*make)(base::RandomSource&);
  };
  static constexpr std::array<Kind, 5> kKinds = {{{"checkers", checkers},
                                                  {"stripes", stripes},
                                                  {"dots", dots},
                                                  {"gradient", gradient},
                                                  {"clouds", clouds}}};
  const Kind& kind = kKinds.at(random.index(kKinds.size()));
  const cv::Vec4b first = drawColour(random);
  const cv::Vec4b second = drawColour(random);
  auto texture = std::make_shared<world::Texture>();
  texture->file = kind.name;
  texture->pixels = painted(kind.make(random), first, second);
  return {kind.name, std::move(texture)};
}

}  // namespace synthetic_dataset::randomize

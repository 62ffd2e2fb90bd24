#include "randomize/appearance/natural/natural_colour.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "randomize/appearance/natural/quick_draws.h"

namespace synthetic_dataset::randomize::natural {
namespace {

struct HueRange {
  double hue[2];  ///< in sixths of the circle, from red to yellow
  double saturation[2];
  double value[2];
  double weight;  ///< how often it occurs
};

// In the order of Hues.
constexpr std::array<HueRange, 9> kRanges = {{{{0.3, 4.0}, {0.00, 0.07}, {0.20, 0.85}, 0.30},
                                              {{0.3, 0.7}, {0.15, 0.50}, {0.28, 0.70}, 0.20},
                                              {{0.6, 1.0}, {0.15, 0.45}, {0.40, 0.80}, 0.08},
                                              {{1.0, 1.9}, {0.20, 0.60}, {0.22, 0.60}, 0.11},
                                              {{3.3, 3.7}, {0.10, 0.45}, {0.30, 0.80}, 0.08},
                                              {{0.1, 0.4}, {0.35, 0.65}, {0.30, 0.62}, 0.06},
                                              {{0.5, 0.9}, {0.04, 0.22}, {0.65, 0.96}, 0.10},
                                              {{0.0, 6.0}, {0.00, 0.30}, {0.10, 0.22}, 0.06},
                                              {{0.0, 6.0}, {0.60, 0.95}, {0.40, 0.92}, 0.06}}};

Colour fromHue(double hue, double saturation, double value) {
  const auto channel = [&](double offset) {
    double k = offset + hue;
    if (k >= 6.0) k -= 6.0;
    const double share = std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
    return static_cast<int>(std::lround(255.0 * (value - value * saturation * share)));
  };
  return {channel(1.0), channel(3.0), channel(5.0)};
}

}  // namespace

Colour drawColour(base::RandomSource& random, Hues hues) {
  const HueRange& range = kRanges[static_cast<std::size_t>(hues)];
  double hue = random.uniform(range.hue[0], range.hue[1]);
  // Vivid things are painted: more often red, yellow and blue than turquoise and pink.
  if (hues == Hues::kVivid && chance(random, 0.6)) {
    constexpr std::array<double, 5> kPaints = {0.05, 0.4, 0.85, 3.6, 2.2};
    hue = kPaints[static_cast<std::size_t>(below(random, 5))] + random.uniform(0.0, 0.12);
  }
  const double saturation = random.uniform(range.saturation[0], range.saturation[1]);
  return fromHue(hue, saturation, random.uniform(range.value[0], range.value[1]));
}

Colour drawAnyColour(base::RandomSource& random) {
  double rest = random.unit();
  std::size_t hues = 0;
  while (hues + 1 < kRanges.size() && rest >= kRanges[hues].weight) rest -= kRanges[hues++].weight;
  return drawColour(random, static_cast<Hues>(hues));
}

Colour mixed(const Colour& first, const Colour& second, int share) {
  const auto mix = [&](int a, int b) { return a + (b - a) * share / 256; };
  return {mix(first.blue, second.blue), mix(first.green, second.green), mix(first.red, second.red)};
}

Colour lit(const Colour& colour, int light) {
  const auto lighten = [&](int channel) { return std::clamp(channel * light / 256, 0, 255); };
  return {lighten(colour.blue), lighten(colour.green), lighten(colour.red)};
}

void addRamp(Palette& palette, int first, int last, const Colour& from, const Colour& to) {
  const int steps = std::max(1, last - first);
  for (int tone = first; tone <= last; ++tone) {
    palette[static_cast<std::size_t>(tone)] =
        pixelOf(mixed(from, to, (tone - first) * 256 / steps));
  }
}

void addShades(Palette& palette, int first, int last, const Colour& colour, int contrast) {
  addRamp(palette, first, last, lit(colour, 256 - contrast), lit(colour, 256 + contrast));
}

}  // namespace synthetic_dataset::randomize::natural

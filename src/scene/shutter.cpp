#include "scene/shutter.h"

#include <algorithm>
#include <cmath>

namespace synthetic_dataset::scene {
namespace {

/// The middle of part `i` of `count` equal parts of a span of time around 0.
double middleOf(int i, int count, Duration span) {
  return ((i + 0.5) / count - 0.5) * static_cast<double>(span.count());
}

}  // namespace

std::vector<Shot> shotsOf(const Shutter& shutter, int height) {
  const int samples = shutter.exposure_time.count() > 0 ? shutter.motion_samples : 1;
  const bool rolls = shutter.readout_time.count() > 0;
  const int bands = std::min(shutter.readout_bands, height);
  std::vector<Shot> shots;
  for (int sample = 0; sample < samples; ++sample) {
    const double middle = middleOf(sample, samples, shutter.exposure_time);
    Shot& shot = shots.emplace_back();
    shot.weight = 1.0 / samples;
    if (!rolls) shot.moments = {{Duration(std::llround(middle)), 0.0}};
    for (int border = 0; rolls && border <= bands; ++border) {
      const double share = static_cast<double>(border) / bands;
      const double offset =
          middle + (share - 0.5) * static_cast<double>(shutter.readout_time.count());
      // A row's time is that of its middle.
      shot.moments.push_back({Duration(std::llround(offset)), share * height - 0.5});
    }
  }
  return shots;
}

}  // namespace synthetic_dataset::scene

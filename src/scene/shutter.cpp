#include "scene/shutter.h"

#include <algorithm>
#include <cmath>

namespace synthetic_dataset::scene {
namespace {

/// The middle of part `i` of `count` equal parts of a span of time round 0.
double middleOf(int i, int count, Duration span) {
  return ((i + 0.5) / count - 0.5) * static_cast<double>(span.count());
}

}  // namespace

std::vector<Shot> shotsOf(const Shutter& shutter, int height) {
  const int samples = shutter.exposure_time.count() > 0 ? shutter.motion_samples : 1;
  const int bands = shutter.readout_time.count() > 0 ? std::min(shutter.readout_bands, height) : 1;
  std::vector<Shot> shots;
  for (int band = 0; band < bands; ++band) {
    const int first = band * height / bands;
    const int end = (band + 1) * height / bands;
    for (int sample = 0; sample < samples; ++sample) {
      const double offset = middleOf(band, bands, shutter.readout_time) +
                            middleOf(sample, samples, shutter.exposure_time);
      shots.push_back({Duration(std::llround(offset)), first, end - first, 1.0 / samples});
    }
  }
  std::stable_sort(shots.begin(), shots.end(),
                   [](const Shot& a, const Shot& b) { return a.offset < b.offset; });
  return shots;
}

}  // namespace synthetic_dataset::scene

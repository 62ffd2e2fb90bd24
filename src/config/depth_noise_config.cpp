#include "config/readers.h"

#include <string>

#include "config/checked_values.h"

namespace synthetic_dataset::config {

render::DepthNoise readDepthNoise(Parameters& camera) {
  render::DepthNoise noise;
  if (!camera.has("depth_noise")) return noise;
  Parameters group = camera.group("depth_noise");
  const std::string model = group.requiredChoice("model", {"none", "structured_light", "stereo"});
  if (model != "structured_light" && model != "stereo") {
    // Other settings are ignored, so that `none` switches noise off.
    for (const char* name :
         {"baseline", "disparity_step", "disparity_noise", "max_angle", "min_depth", "max_depth"}) {
      group.ignore(name);
    }
    return noise;
  }
  constexpr double kLongest = 100.0;      // [m]
  constexpr double kCoarsest = 16.0;      // [px]
  constexpr double kMostNoise = 16.0;     // [px]
  constexpr double kRightAngle = 1.5707;  // [rad]
  const bool is_stereo = model == "stereo";
  noise.model = is_stereo ? render::DepthModel::kStereo : render::DepthModel::kStructuredLight;
  noise.baseline = group.optionalBetween("baseline", is_stereo ? 0.05 : 0.075, 1e-4, kLongest);
  noise.disparity_step =
      group.optionalBetween("disparity_step", is_stereo ? 0.03125 : 0.125, 0.0, kCoarsest);
  if (is_stereo) {
    noise.disparity_noise = group.optionalBetween("disparity_noise", 0.08, 0.0, kMostNoise);
    refuseWithout(group, {"max_angle"}, "model: structured_light");
  } else {
    noise.greatest_angle = group.optionalBetween("max_angle", 1.4, 0.0, kRightAngle);
    refuseWithout(group, {"disparity_noise"}, "model: stereo");
  }
  if (!is_stereo || group.has("min_depth")) {
    noise.min_depth = group.optionalBetween("min_depth", is_stereo ? 0.0 : 0.5, 0.0, 1e6);
  }
  if (!is_stereo || group.has("max_depth")) {
    noise.max_depth = numberAbove(group, "max_depth", is_stereo ? 1e6 : 5.0, noise.min_depth);
  }
  return noise;
}

}  // namespace synthetic_dataset::config

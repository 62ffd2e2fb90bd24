#include "run/setup/open_times.h"

#include <algorithm>
#include <string>

#include "run/setup/scene_plan.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::run {
namespace {

/// The shortest time from one scene to the next, and its description.
struct ScenePeriod {
  Duration time{0};
  std::string name;
};

ScenePeriod periodOf(const MotionSetup& setup) {
  const config::Config& config = setup.config;
  if (!config.hasRecordedTimes()) {
    return {shortestPeriod(config),
            std::string("from one scene to the next (simulated_rate") +
                (config.randomization.time_jitter ? ", less the range of randomize/time/jitter)"
                                                  : ")")};
  }
  ScenePeriod period{Duration::max(), std::string("between two recorded ") +
                                          (config.isTwin() ? "pictures" : "clouds")};
  const std::vector<Stamp>& stamps = setup.timeline.stamps;
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    period.time = std::min(period.time, stamps[i] - stamps[i - 1]);
  }
  return period;
}

}  // namespace

void checkOpenTimes(MotionSetup& setup) {
  const ScenePeriod period = periodOf(setup);
  const auto refuse = [&](const std::string& setting, const std::string& found, Duration open) {
    if (open <= period.time) return;
    setup.diagnostics.error(setting, "found " + found + fixed(toSeconds(open), 4) +
                                         " s; it should be at most the " +
                                         fixed(toSeconds(period.time), 4) + " s " + period.name);
  };
  for (const scene::CameraOptions& camera : setup.config.cameras) {
    for (const scene::CameraRig& rig : setup.cameras) {
      if (rig.name != camera.name) continue;
      refuse(camera.group + "/effects", "exposure_time + readout_time of ",
             scene::openTime(rig.shutter));
    }
  }
  for (const lidar::LidarRig& lidar : setup.lidars) {
    if (lidar.recorded) continue;
    refuse(lidar.group + "/rate", Value(lidar.model.rate).text() + " Hz, at which a sweep takes ",
           lidar::sweepTime(lidar.model));
  }
}

}  // namespace synthetic_dataset::run

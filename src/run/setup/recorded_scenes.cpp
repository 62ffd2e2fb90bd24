#include "run/setup/recorded_scenes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::run {
namespace {

/// Keeps the scenes for which a lidar has a cloud.
void keepScenesOf(const lidar::LidarRig& lidar, std::vector<Stamp>& scenes,
                  base::Diagnostics& diagnostics) {
  const Duration longest = lidar.recorded->options().longest_distance;
  const std::string within =
      " within " + fixed(1e3 * toSeconds(longest), 0) + " ms (" + lidar.group + "/cloud_time)";
  std::vector<Stamp> kept;
  std::vector<Duration> distances;
  for (const Stamp scene : scenes) {
    distances.push_back(lidar.recorded->distanceTo(scene));
    if (distances.back() <= longest) kept.push_back(scene);
  }
  const auto lost = static_cast<std::int64_t>(scenes.size() - kept.size());
  if (kept.empty()) {
    std::sort(distances.begin(), distances.end());
    throw Error(lidar.group + "/cloud_topic: no cloud is" + within +
                " of a scene; the nearest are " +
                fixed(1e3 * toSeconds(distances[distances.size() / 2]), 0) + " ms away (median)");
  }
  if (lost > 0) {
    diagnostics.warning(lidar.group + "/cloud_topic", "scene left out: there is no cloud" + within,
                        lost);
  }
  scenes = std::move(kept);
}

}  // namespace

std::vector<Stamp> scenesWithClouds(const std::vector<lidar::LidarRig>& lidars,
                                    std::vector<Stamp> scenes, base::Diagnostics& diagnostics) {
  for (const lidar::LidarRig& lidar : lidars) {
    if (lidar.recorded) keepScenesOf(lidar, scenes, diagnostics);
  }
  return scenes;
}

void checkClouds(const std::vector<lidar::LidarRig>& lidars, const std::vector<Stamp>& scenes,
                 const world::World& world, base::Diagnostics& diagnostics) {
  constexpr Duration kInexact = std::chrono::milliseconds(5);
  for (const lidar::LidarRig& lidar : lidars) {
    if (!lidar.recorded) continue;
    if (const auto problem = lidar.recorded->problem(scenes)) diagnostics.error("", *problem);
    if (world.propPoses().empty()) continue;
    for (std::size_t i = 1; i < scenes.size(); ++i) {
      const Stamp end = scenes[i - 1] + std::max(lidar.sweepAt(scenes[i - 1]).last, Duration{0});
      const Duration begin = std::min(lidar.sweepAt(scenes[i]).first, Duration{0});
      if (scenes[i] >= end && scenes[i] + begin + kInexact >= end) continue;
      diagnostics.error(lidar.group + "/cloud_topic",
                        "the clouds of two scenes overlap by " +
                            fixed(1e3 * toSeconds(end - scenes[i] - begin), 0) +
                            " ms, and the world has models moved by physics, which only runs "
                            "forward; `every`, or twin/every of recorded pictures, leaves scenes "
                            "out between them");
      break;
    }
  }
}

}  // namespace synthetic_dataset::run

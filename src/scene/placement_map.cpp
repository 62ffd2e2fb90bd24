#include "scene/placement_map.h"

#include <string>

#include "motion/frame_names.h"
#include "motion/recorded/recorded_map.h"
#include "randomize/placement/map_reader.h"
#include "randomize/placement/received_map.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::scene {
namespace {

/// The map received on the topic, from a running system or from the bags.
motion::RecordedMap topicsMap(const SceneOptions& config) {
  const randomize::PlacementOptions& placement = config.placement;
  if (placement.received_map) return randomize::receivedMap(*placement.received_map);
  if (!config.motion.bag_files.empty()) {
    return motion::readMap(config.motion.bag_files, *placement.map_topic);
  }
  throw Error("found '" + *placement.map_topic +
              "', a topic without a source; bag_file should name the bags in which it was "
              "recorded, or `generate` should run beside the system that publishes it, as a node "
              "(roslaunch, or rosrun without --config); or placement/map should name map_server's "
              "YAML file");
}

}  // namespace

randomize::OccupancyMap readPlacementMap(const SceneOptions& config,
                                         base::Diagnostics& diagnostics) {
  const randomize::PlacementOptions& placement = config.placement;
  if (placement.map_file) {
    try {
      return randomize::readMapFile(*placement.map_file, [&](const std::string& found) {
        diagnostics.warning("placement/map", found);
      });
    } catch (const ErrorList&) {
      throw;
    } catch (const Error& error) {
      throw Error(std::string("placement/map: ") + error.what());
    }
  }
  try {
    const motion::RecordedMap map = topicsMap(config);
    const std::string global_frame = motion::withoutLeadingSlashes(config.global_frame);
    if (map.frame == global_frame) return randomize::mapOf(map);
    throw Error("found '" + *placement.map_topic + "', a map in the frame '" + map.frame +
                "'; it should be in global_frame, '" + global_frame + "'");
  } catch (const ErrorList&) {
    throw;
  } catch (const Error& error) {
    throw Error(std::string("placement/map_topic: ") + error.what());
  }
}

}  // namespace synthetic_dataset::scene

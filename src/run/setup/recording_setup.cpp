#include "run/setup/recording_setup.h"

#include <set>
#include <string>
#include <vector>

#include "motion/bag_motion.h"
#include "run/setup/input_cache.h"
#include "run/setup/world_files.h"
#include "scene/link_names.h"
#include "synthetic_dataset/errors.h"
#include "world/description.h"

namespace synthetic_dataset::run {
namespace {

/// The frames that have to be known: those of objects, and of sensors that follow their frame.
std::vector<std::string> neededFrames(const config::Config& config) {
  std::vector<std::string> frames;
  std::set<std::string> objects;
  for (const scene::ObjectOptions& object : config.objects) {
    objects.insert(object.name);
    const bool is_followed = object.takes_part && !object.is_distractor && !object.stands;
    if (is_followed) frames.push_back(object.frame);
  }
  for (const scene::CameraOptions& camera : config.cameras) {
    const bool has_pose = camera.X_GC || camera.aim || camera.on || camera.sample || camera.sensor;
    if (camera.frame && !has_pose) frames.push_back(*camera.frame);
    if (camera.on && objects.count(*camera.on) == 0) frames.push_back(*camera.on);
  }
  for (const lidar::LidarOptions& lidar : config.lidars) {
    if (!lidar.X_GS && !lidar.on && !lidar.sensor) frames.push_back(lidar.frame);
  }
  return frames;
}

/// The objects whose models have joints. Models that cannot be read are reported with the world.
std::vector<motion::JointedRobot> robotsOf(const config::Config& config, WorldFiles& files) {
  std::vector<motion::JointedRobot> robots;
  for (const scene::ObjectOptions& object : config.objects) {
    if (!object.takes_part || !object.model || object.stands) continue;
    try {
      const world::Model& model = files.model(*object.model, object.name, object.model_arguments);
      const auto robot = scene::jointedRobot(model, object);
      if (robot) robots.push_back(*robot);
    } catch (const Error&) {
      continue;
    }
  }
  return robots;
}

}  // namespace

std::shared_ptr<const motion::FrameSource> openRecording(const config::Config& config,
                                                         InputCache& inputs) {
  const motion::MotionOptions& motion = config.motion;
  return inputs.recordings.get(motion::BagMotionOptions{
      motion.bag_files, config.global_frame, motion.stretch, motion.tf_topics, motion.pose_topics,
      neededFrames(config),
      [&] { return robotsOf(config, inputs.worlds.filesFor(config.world)); }});
}

}  // namespace synthetic_dataset::run

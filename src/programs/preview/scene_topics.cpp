#include "programs/preview/scene_topics.h"

#include <set>
#include <utility>

#include <ros/time.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/image_encodings.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include "base/ros_messages/image_messages.h"
#include "programs/drawing/scene_picture.h"
#include "programs/preview/preview_markers.h"
#include "programs/preview/preview_world.h"

namespace synthetic_dataset::programs {
namespace {

namespace encodings = sensor_msgs::image_encodings;

Stamp now() { return Stamp(static_cast<Stamp::rep>(ros::WallTime::now().toNSec())); }

bool isHeard(const ros::Publisher& publisher) { return publisher.getNumSubscribers() > 0; }

}  // namespace

SceneTopics::SceneTopics(ros::NodeHandle& node, const std::string& frame_prefix,
                         std::function<void()> on_missing)
    : node_(node),
      frame_prefix_(frame_prefix),
      on_missing_(std::move(on_missing)),
      frames_("", frame_prefix),
      transforms_(node.advertise<tf2_msgs::TFMessage>("/tf", 10)),
      labels_(advertise<visualization_msgs::MarkerArray>("labels",
                                                         [this] { return made_.visible_masks; })),
      view_markers_(advertise<visualization_msgs::MarkerArray>("views")),
      ways_(advertise<visualization_msgs::MarkerArray>("ways")),
      clouds_(advertise<visualization_msgs::MarkerArray>(
          "clouds", [this] { return made_.clouds || !has_lidars_; })),
      world_(advertise<visualization_msgs::MarkerArray>("world", [this] { return shows_world_; })) {
}

template <class Message>
ros::Publisher SceneTopics::advertise(const std::string& topic, std::function<bool()> is_made) {
  constexpr std::uint32_t kQueue = 4;
  const auto ask =
      [this, is_made = std::move(is_made)](const ros::SingleSubscriberPublisher& /*listener*/) {
        bool is_missing = false;
        if (is_made) {
          const std::lock_guard<std::mutex> lock(mutex_);
          is_missing = !is_made();
        }
        if (is_missing) on_missing_();
      };
  return node_.advertise<Message>(topic, kQueue, ask, {}, {}, true);
}

/// The world's message is large, and is made only if somebody subscribes.
void SceneTopics::showWorld(const world::World& world) {
  const bool is_heard = isHeard(world_);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    shows_world_ = is_heard;
  }
  if (is_heard) world_.publish(worldMarkers(world, frames_, now()));
}

void SceneTopics::open(const run::RunSetup& setup) {
  frames_ = ros_messages::SceneFrames(setup.config.global_frame, frame_prefix_);
  std::vector<std::string> names;
  for (const scene::CameraRig& rig : setup.motions.front().cameras) names.push_back(rig.name);
  camera_topics_ = ros_messages::topicNames(names);
  std::vector<Camera> before = std::exchange(cameras_, {});
  std::set<std::string> placed;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& frame = setup.motions.front().cameras[i].optical_frame;
    const ros_messages::CameraFrame camera{frame, placed.insert(frame).second, i == 0};
    if (i < before.size() && before[i].name == names[i]) {
      cameras_.push_back(std::move(before[i]));
      cameras_.back().frame = camera;
    } else {
      addCamera(names[i], camera_topics_[i], camera);
    }
  }
  views_.assign(names.size(), {});
  ways_.publish(wayMarkers(setup.motions.front(), frames_, now()));
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    has_lidars_ = !setup.motions.front().lidars.empty();
  }
  showWorld(*setup.motions.front().world);
}

void SceneTopics::addCamera(const std::string& name, const std::string& topic,
                            const ros_messages::CameraFrame& frame) {
  using sensor_msgs::CameraInfo;
  using sensor_msgs::Image;
  const auto has_masks = [this] { return made_.visible_masks; };
  cameras_.push_back({name, frame, advertise<Image>(topic + "/image_raw"),
                      advertise<CameraInfo>(topic + "/camera_info"),
                      advertise<Image>(topic + "/image_labels", has_masks),
                      advertise<Image>(topic + "/depth/image_raw", [this] { return made_.depth; }),
                      advertise<CameraInfo>(topic + "/depth/camera_info"),
                      advertise<Image>(topic + "/instances", has_masks)});
}

Requirements SceneTopics::takeRequirements() {
  Requirements needed;
  needed.visible_masks = isHeard(labels_);
  for (const Camera& camera : cameras_) {
    if (isHeard(camera.labelled) || isHeard(camera.instances)) needed.visible_masks = true;
    if (isHeard(camera.depth)) needed.depth = true;
  }
  needed.keypoint_states = needed.visible_masks;
  needed.clouds = has_lidars_ && isHeard(clouds_);
  const std::lock_guard<std::mutex> lock(mutex_);
  made_ = needed;
  return needed;
}

void SceneTopics::show(const Scene& scene) {
  Scene shown = scene;
  shown.stamp = now();
  const Camera& camera = cameras_.at(scene.camera_index);
  const std_msgs::Header header =
      ros_messages::headerOf(shown.stamp, frames_.of(camera.frame.name));
  transforms_.publish(ros_messages::transforms(shown, camera.frame, frames_));
  const sensor_msgs::CameraInfo info = ros_messages::cameraInfo(header, scene.camera);
  camera.info.publish(info);
  camera.image.publish(ros_messages::imageMessage(header, encodings::BGR8, scene.image));
  views_.at(scene.camera_index) = viewMarker(shown, frames_);
  if (scene.camera_index + 1 == cameras_.size()) {
    visualization_msgs::MarkerArray views;
    views.markers = views_;
    view_markers_.publish(views);
  }
  if (scene.depth.isKnown()) {
    camera.depth_info.publish(info);
    camera.depth.publish(ros_messages::depthMessage(header, scene.depth()));
  }
  if (scene.instance_map.isKnown()) showLabels(shown, camera, header);
  if (scene.clouds.isKnown() && scene.camera_index == 0) {
    clouds_.publish(cloudMarkers(shown, frames_));
  }
}

void SceneTopics::showLabels(const Scene& scene, const Camera& camera,
                             const std_msgs::Header& header) {
  if (scene.camera_index == 0) labels_.publish(labelMarkers(scene, frames_));
  camera.labelled.publish(
      ros_messages::imageMessage(header, encodings::BGR8, pictureWithLabels(scene)));
  camera.instances.publish(
      ros_messages::imageMessage(header, encodings::MONO16, scene.instance_map()));
}

}  // namespace synthetic_dataset::programs

#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "lidar/lidar_rig.h"
#include "lidar/sweep_taker.h"
#include "support/bag_builder.h"
#include "support/box_world.h"
#include "support/fake_frame_source.h"
#include "world/world.h"

namespace synthetic_dataset::test {

constexpr Stamp kSweepTime = std::chrono::seconds(1'600'000'000);

/// A model of one link with one visual.
inline world::Model modelOf(const std::string& name, std::shared_ptr<const world::Mesh> mesh,
                            const Pose& X_WM, const world::Material& material = {}) {
  world::Visual visual;
  visual.name = "v";
  visual.surfaces.push_back({std::move(mesh), material});
  world::Link link;
  link.name = "body";
  link.visuals.push_back(std::move(visual));
  world::Model model;
  model.name = name;
  model.is_static = true;
  model.X_WM = X_WM;
  model.links.push_back(std::move(link));
  return model;
}

/// A hall of 16 x 12 x 4 m around the origin, of four walls and a floor, and boxes in it that move
/// all the time, each in its own way.
class ScannedHall {
 public:
  /// @param stray  height of another box above the hall's origin [m]; 0 for none
  explicit ScannedHall(int boxes, const Eigen::Vector3d& origin = Eigen::Vector3d::Zero(),
                       double stray = 0.0)
      : origin_(origin) {
    world::Description description;
    const auto add = [&](const std::string& name, const Eigen::Vector3d& size, double x, double y,
                         double z) {
      description.models.push_back(modelOf(name, boxMesh(size), at({x, y, z})));
    };
    add("floor", {16, 12, 0.2}, 0, 0, -1.1);
    add("east", {0.2, 12, 4}, 8, 0, 1);
    add("west", {0.2, 12, 4}, -8, 0, 1);
    add("north", {16, 0.2, 4}, 0, 6, 1);
    add("south", {16, 0.2, 4}, 0, -6, 1);
    if (stray > 0.0) add("stray", {1, 1, 1}, 0, 0, stray);
    std::vector<world::MovingObject> objects;
    for (int i = 0; i < boxes; ++i) {
      world::Model model =
          modelOf("box" + std::to_string(i),
                  boxMesh({0.4 + 0.1 * (i % 3), 0.5, 0.6 + 0.1 * (i % 4)}), Pose::Identity());
      model.is_static = false;
      objects.emplace_back(std::move(model));
    }
    world_ = std::make_unique<world::World>(std::move(description), std::move(objects),
                                            world::PhysicsOptions());
    world_->advanceTo(kSweepTime - std::chrono::seconds(1), poseAt());
  }

  /// X_WO of a box: it circles and spins, at up to 3 m/s.
  [[nodiscard]] Pose boxPose(int box, Stamp time) const {
    const double t = toSeconds(time - kSweepTime);
    const double angle = 0.6 * t + 0.79 * box;
    const double radius = 3.0 + 0.4 * (box % 6);
    return at({radius * std::cos(angle), radius * std::sin(angle), -0.3 + 0.1 * (box % 5)},
              (1.0 + 0.3 * box) * t);
  }

  [[nodiscard]] world::World::ObjectPoseAt poseAt() const {
    return [this](int box, Stamp time) { return world::ObjectPose(boxPose(box, time)); };
  }

  /// X_GS of a scanner that drives at 2 m/s and turns at 1 rad/s, within the boxes' circles.
  [[nodiscard]] Pose driving(Stamp time) const {
    const double t = toSeconds(time - kSweepTime);
    return at({2.0 * std::sin(t), -2.0 * std::cos(t), 0.2}, t);
  }

  [[nodiscard]] FakeFrameSource frames(bool drives = true) const {
    return FakeFrameSource(
        {{"scanner", [this, drives](Stamp time) { return driving(drives ? time : kSweepTime); }}});
  }

  [[nodiscard]] world::World& world() { return *world_; }

  /// Poses of all links at a time, without advancing the world.
  [[nodiscard]] std::vector<Pose> linkPoses(Stamp time) const {
    std::vector<Pose> poses = world_->linkPoses();
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const int object = world_->links()[i].object;
      if (object >= 0) poses[i] = boxPose(object, time);
    }
    return poses;
  }

  /// Labels as in a run: each box is an instance, and its part number is twice the instance's.
  [[nodiscard]] std::vector<lidar::LinkLabel> labels() const {
    std::vector<lidar::LinkLabel> labels;
    for (const world::LinkInstance& link : world_->links()) {
      const auto instance = static_cast<std::uint16_t>(link.object + 1);
      const auto place = static_cast<std::uint16_t>(labels.size() + 1);
      labels.push_back({instance, static_cast<std::uint16_t>(instance > 0 ? 1 : 0),
                        static_cast<std::uint16_t>(instance > 0 ? 0 : place),
                        static_cast<std::uint16_t>(2 * instance)});
    }
    return labels;
  }

  [[nodiscard]] Pose at(const Eigen::Vector3d& position, double yaw = 0.0) const {
    return makePose(origin_ + position,
                    Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ())));
  }

 private:
  Eigen::Vector3d origin_;
  std::unique_ptr<world::World> world_;
};

/// A scanner without noise or dropout.
inline lidar::LidarModel exactModel(int rings, int columns) {
  lidar::LidarModel model;
  model.elevations = lidar::evenAngles(rings, -0.4, 0.3);
  model.columns = columns;
  model.first_azimuth = M_PI;
  model.last_azimuth = -M_PI;
  model.min_range = 0.1;
  return model;
}

inline lidar::LidarRig scannerOf(const lidar::LidarModel& model,
                                 const motion::FrameSource& frames) {
  lidar::LidarOptions options;
  options.name = "top";
  options.group = "lidars/top";
  options.frame = "scanner";
  options.model = model;
  base::Diagnostics notes;
  return lidar::makeLidarRig(options, {}, frames, notes);
}

/// The cloud that a scanner takes around a time, while the boxes in the hall move.
inline Cloud cloudIn(ScannedHall& hall, const lidar::LidarModel& model,
                     const motion::FrameSource& frames, Stamp stamp = kSweepTime) {
  const std::vector<lidar::LidarRig> lidars = {scannerOf(model, frames)};
  lidar::SweepTaker taker(hall.world(), frames, lidars, hall.labels(),
                          render::GlassInLabels::kOfObjects, 7);
  taker.begin(stamp);
  for (const Duration offset : taker.offsets(stamp)) {
    hall.world().advanceTo(stamp + offset, hall.poseAt());
    taker.look(offset);
  }
  return *taker.take(0, {})().clouds.front();
}

}  // namespace synthetic_dataset::test

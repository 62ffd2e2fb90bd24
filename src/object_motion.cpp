#include "object_motion.h"

#include <algorithm>
#include <utility>

namespace synthetic_dataset {
namespace {

/// The model's links, parents before children.
std::vector<std::size_t> parentsFirst(const std::vector<const world::Link*>& links) {
  std::vector<std::pair<std::size_t, std::size_t>> by_depth;
  for (std::size_t i = 0; i < links.size(); ++i) {
    std::size_t depth = 0;
    for (auto at = links[i]->parent; at; at = links[*at]->parent) ++depth;
    by_depth.emplace_back(depth, i);
  }
  std::sort(by_depth.begin(), by_depth.end());
  std::vector<std::size_t> order;
  for (const auto& [depth, link] : by_depth) order.push_back(link);
  return order;
}

}  // namespace

ObjectMotion::ObjectMotion(const motion::FrameMotion& frames, const config::Config& config,
                           const std::vector<world::LinkInstance>& links,
                           const std::vector<std::vector<DrivenLink>>& driven)
    : frames_(frames) {
  std::vector<std::vector<const world::Link*>> links_of(config.objects.size());
  for (const world::LinkInstance& each : links) {
    if (each.object >= 0) links_of[static_cast<std::size_t>(each.object)].push_back(each.link);
  }
  for (std::size_t i = 0; i < config.objects.size(); ++i) {
    Object object;
    object.name = config.objects[i].name;
    object.frame = config.objects[i].frame;
    for (const world::Link* link : links_of[i]) {
      const Pose X_OL = link->X_ML;
      const Pose X_PL =
          link->parent ? Pose(links_of[i][*link->parent]->X_ML.inverse() * X_OL) : X_OL;
      object.links.push_back({link->name, link->parent, std::nullopt, X_PL});
    }
    for (const DrivenLink& each : driven[i]) {
      object.links[each.link].frame = each.frame;
      object.driven.push_back(each.link);
    }
    object.order = parentsFirst(links_of[i]);
    objects_.push_back(std::move(object));
  }
}

std::optional<Pose> ObjectMotion::lookUp(const std::string& frame, Stamp time) const {
  if (!frames_.hasPose(frame, time)) return std::nullopt;
  return frames_.pose(frame, time);
}

const Pose& ObjectMotion::objectPose(Object& object, Stamp time) const {
  if (const auto X_GO = lookUp(object.frame, time)) object.X_GO = *X_GO;
  return object.X_GO;
}

Pose ObjectMotion::linkPose(Object& object, LinkState& link, const Pose& X_GP, Stamp time) {
  if (!link.frame) return X_GP * link.X_PL;
  if (const auto X_GL = lookUp(*link.frame, time)) {
    link.X_PL = X_GP.inverse() * *X_GL;
    return *X_GL;
  }
  if (!std::exchange(link.gap_told, true)) {
    gaps_.push_back("'" + object.name + "': the frame '" + *link.frame + "' of its link '" +
                    link.name +
                    "' is not known to TF all the time; meanwhile the link keeps its place on what "
                    "it hangs on");
  }
  return X_GP * link.X_PL;
}

world::ObjectPose ObjectMotion::at(int index, Stamp time) {
  Object& object = objects_[static_cast<std::size_t>(index)];
  world::ObjectPose pose(objectPose(object, time));
  if (object.driven.empty()) return pose;
  std::vector<Pose> X_GL(object.links.size());
  for (const std::size_t i : object.order) {
    LinkState& link = object.links[i];
    X_GL[i] = linkPose(object, link, link.parent ? X_GL[*link.parent] : pose.X_WO, time);
  }
  for (const std::size_t link : object.driven) pose.X_WL.push_back(X_GL[link]);
  return pose;
}

std::vector<Pose> ObjectMotion::objectPoses(Stamp time) {
  std::vector<Pose> poses;
  for (Object& object : objects_) poses.push_back(objectPose(object, time));
  return poses;
}

std::vector<std::string> ObjectMotion::takeGaps() { return std::exchange(gaps_, {}); }

}  // namespace synthetic_dataset

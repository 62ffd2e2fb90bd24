#include "scene/object_motion.h"

#include <algorithm>
#include <utility>

#include "label/object_links.h"

namespace synthetic_dataset::scene {
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

ObjectMotion::ObjectMotion(const motion::FrameSource& frames,
                           const std::vector<ObjectOptions>& objects,
                           const std::vector<world::LinkInstance>& links,
                           const std::vector<std::vector<DrivenLinks>>& driven)
    : frames_(frames) {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const ObjectOptions& object = objects[i];
    objects_.push_back({object.name, frames.find(object.frame).value_or(motion::kNoFrame),
                        object.when_unknown == WhenUnknown::kAbsent});
    for (std::size_t variant = 0; variant < driven[i].size(); ++variant) {
      const auto own = label::linksAt(label::linksOfVariant(i, variant, links), links);
      variants_.push_back(makeVariant(i, own, driven[i][variant]));
    }
  }
}

ObjectMotion::Variant ObjectMotion::makeVariant(std::size_t object,
                                                const std::vector<const world::Link*>& links,
                                                const DrivenLinks& driven) {
  Variant variant{object, {}, parentsFirst(links), {}};
  for (const world::Link* link : links) {
    const Pose X_OL = link->X_ML;
    const Pose X_PL = link->parent ? Pose(links[*link->parent]->X_ML.inverse() * X_OL) : X_OL;
    variant.links.push_back({link->name, link->parent, std::nullopt, X_PL});
  }
  for (const DrivenLink& each : driven) {
    variant.links[each.link].frame = each.frame;
    variant.driven.push_back(each.link);
  }
  return variant;
}

const std::optional<Pose>& ObjectMotion::objectPose(Object& object, Stamp time) const {
  const auto X_GO = frames_.pose(object.frame, time);
  if (X_GO || object.may_be_absent) object.X_GO = X_GO;
  return object.X_GO;
}

Pose ObjectMotion::linkPose(const Object& object, LinkState& link, const Pose& X_GP, Stamp time) {
  if (!link.frame) return X_GP * link.X_PL;
  if (const auto X_GL = frames_.pose(*link.frame, time)) {
    link.X_PL = X_GP.inverse() * *X_GL;
    return *X_GL;
  }
  const std::string gap = "'" + object.name + "': the frame '" + frames_.names().of(*link.frame) +
                          "' of its link '" + link.name +
                          "' is not known to TF all the time; meanwhile the link keeps its place "
                          "on its parent";
  gaps_.insert(gap);
  return X_GP * link.X_PL;
}

std::optional<world::ObjectPose> ObjectMotion::at(int moving_object, Stamp time) {
  Variant& variant = variants_[static_cast<std::size_t>(moving_object)];
  Object& object = objects_[variant.object];
  const std::optional<Pose>& X_GO = objectPose(object, time);
  if (!X_GO) return std::nullopt;
  world::ObjectPose pose(*X_GO);
  if (variant.driven.empty()) return pose;
  std::vector<Pose> X_GL(variant.links.size());
  for (const std::size_t i : variant.order) {
    LinkState& link = variant.links[i];
    X_GL[i] = linkPose(object, link, link.parent ? X_GL[*link.parent] : pose.X_WO, time);
  }
  for (const std::size_t link : variant.driven) pose.X_WL.push_back(X_GL[link]);
  return pose;
}

std::vector<std::optional<Pose>> ObjectMotion::objectPoses(Stamp time) {
  std::vector<std::optional<Pose>> poses;
  for (Object& object : objects_) poses.push_back(objectPose(object, time));
  return poses;
}

std::set<std::string> ObjectMotion::takeGaps() { return std::exchange(gaps_, {}); }

}  // namespace synthetic_dataset::scene

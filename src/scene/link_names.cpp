#include "scene/link_names.h"

#include <algorithm>

#include "motion/frame_names.h"

namespace synthetic_dataset::scene {
namespace {

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

std::string lastPart(const std::string& link) {
  const std::size_t scope = link.rfind("::");
  return scope == std::string::npos ? link : link.substr(scope + 2);
}

bool isCalled(const std::string& frame, const std::string& name) {
  const std::string below = "/" + name;
  return frame == name || (frame.size() > below.size() &&
                           frame.compare(frame.size() - below.size(), below.size(), below) == 0);
}

/// The frame of a link: the one that the settings name, or else the pattern's.
std::string frameOf(const world::Model& model, const world::Link& link,
                    const ObjectOptions& object) {
  const auto named = object.link_frames.by_link.find(link.name);
  if (named != object.link_frames.by_link.end()) return named->second;
  return frameByPattern(object.link_frames.pattern, object.name, frameNames(model, link).front());
}

}  // namespace

std::vector<std::string> frameNames(const world::Model& model, const world::Link& link) {
  std::vector<std::string> names{replaced(link.name, "::", "/")};
  const std::string last = lastPart(link.name);
  const auto namesakes =
      std::count_if(model.links.begin(), model.links.end(),
                    [&](const world::Link& other) { return lastPart(other.name) == last; });
  if (namesakes == 1 && last != link.name) names.push_back(last);
  return names;
}

std::string frameByPattern(const std::string& pattern, const std::string& object,
                           const std::string& link) {
  return replaced(replaced(pattern, "{object}", object), "{link}", link);
}

bool isFrameOfLink(const std::string& frame, const std::string& link, const ObjectOptions& object) {
  const std::string name = motion::withoutLeadingSlashes(frame);
  const auto given = object.link_frames.by_link.find(link);
  if (given != object.link_frames.by_link.end()) return name == given->second;
  const std::string own = replaced(link, "::", "/");
  const std::size_t slash = object.frame.rfind('/');
  const std::string prefix = slash == std::string::npos ? "" : object.frame.substr(0, slash + 1);
  return name == frameByPattern(object.link_frames.pattern, object.name, own) ||
         name == prefix + own || name == own;
}

std::optional<std::size_t> linkNamedBy(const std::string& frame, const world::Model& model,
                                       const std::vector<std::size_t>& links) {
  const std::string name = motion::withoutLeadingSlashes(frame);
  std::optional<std::size_t> named;
  std::size_t longest = 0;  // "arm/wrist" is more specific than "wrist"
  for (const std::size_t link : links) {
    for (const std::string& each : frameNames(model, model.links[link])) {
      if (each.size() <= longest || !isCalled(name, each)) continue;
      longest = each.size();
      named = link;
    }
  }
  return named;
}

std::optional<motion::JointedRobot> jointedRobot(const world::Model& model,
                                                 const ObjectOptions& object) {
  motion::JointedRobot robot{object.name, object.frame, std::nullopt, {}};
  std::vector<std::size_t> all;
  bool any_moves = false;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const world::Link& link = model.links[i];
    motion::JointedLink jointed;
    jointed.frame = frameOf(model, link, object);
    jointed.parent = link.parent;
    jointed.X_PL =
        link.parent ? Pose(model.links[*link.parent].X_ML.inverse() * link.X_ML) : link.X_ML;
    if (link.joint_motion) {
      any_moves = true;
      jointed.joint = link.moving_joint;
      jointed.slides = link.joint_motion->slides;
      jointed.axis_L = link.joint_motion->axis_L;
      jointed.rest = link.joint_motion->rest;
      if (const auto& mimic = link.joint_motion->mimic) {
        jointed.mimic = motion::JointedLink::Mimic{mimic->joint, mimic->multiplier, mimic->offset};
      }
    }
    if (jointed.frame == object.frame) robot.own_link = i;
    robot.links.push_back(jointed);
    all.push_back(i);
  }
  if (!any_moves) return std::nullopt;
  if (!robot.own_link) robot.own_link = linkNamedBy(object.frame, model, all);
  if (robot.own_link) robot.links[*robot.own_link].frame = object.frame;
  return robot;
}

}  // namespace synthetic_dataset::scene

#include "world/sdf/sdf_frames.h"

namespace synthetic_dataset::world {
namespace {

const std::string kOwn;  ///< the name of the model's or the world's own frame: none

}  // namespace

/// In a world, "world" is the world's frame; in a model, "__model__" is the model's.
bool SdfFrames::isOwn(const std::string& name) {
  return name.empty() || name == "__model__" || name == "world" || name == "__root__";
}

void SdfFrames::add(const std::string& name, const RelativePose& pose, const std::string& fallback,
                    const SourceLocation& location) {
  if (name.empty()) return;
  frames_.emplace(name, Frame{pose, fallback, location, std::nullopt, false});
}

void SdfFrames::addInner(const std::string& name, const std::string& prefix, SdfFrames& inner,
                         SdfReading& reading) {
  for (const auto& [inner_name, frame] : inner.frames_) {
    add(prefix + inner_name, {inner.poseOf(inner_name, reading), name}, "", frame.location);
  }
}

Pose SdfFrames::poseOf(const std::string& name, SdfReading& reading) {
  const auto found = frames_.find(name);
  if (found == frames_.end()) return Pose::Identity();
  Frame& frame = found->second;
  if (frame.X_FN) return *frame.X_FN;
  if (frame.is_open) {
    reading.findings.addNote(frame.location,
                             "its pose is relative to itself, by way of others; the circle is cut");
    return Pose::Identity();
  }
  frame.is_open = true;
  frame.X_FN = resolve(frame.pose, frame.fallback, frame.location, reading);
  frame.is_open = false;
  return *frame.X_FN;
}

Pose SdfFrames::resolve(const RelativePose& pose, const std::string& fallback,
                        const SourceLocation& location, SdfReading& reading) {
  // Names come before the reserved words: a saved world may have a link called "world".
  if (knows(pose.frame) || (isOwn(pose.frame) && !pose.frame.empty())) {
    return poseOf(pose.frame, reading) * pose.pose;
  }
  const std::string& name = knows(fallback) ? fallback : kOwn;
  if (!pose.frame.empty()) {
    reading.findings.addNote(
        location, "its pose is relative to '" + pose.frame + "', which is not known here; " +
                      (name.empty() ? "the frame of what it is in" : "'" + name + "'") +
                      " is taken");
  }
  return poseOf(name, reading) * pose.pose;
}

}  // namespace synthetic_dataset::world

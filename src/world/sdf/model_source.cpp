#include "world/sdf/model_source.h"

#include <utility>

namespace synthetic_dataset::world {
namespace {

const std::string kOwn;  ///< the name of the model's or the world's own frame: empty

void addFrame(const Element& element, const std::string& fallback, ModelSource& source,
              SdfReading& reading) {
  const SourceLocation location = locationOf(element, source.location);
  source.frames.add(element.attribute("name"), readPose(element, location, reading), fallback,
                    location);
}

void addOwnFrames(ModelSource& source, SdfReading& reading) {
  for (const Element& link : source.element.children("link")) addFrame(link, "", source, reading);
  for (const Element& joint : source.element.children("joint")) {
    addFrame(joint, readText(joint, "child"), source, reading);
  }
  for (const Element& frame : source.element.children("frame")) {
    addFrame(frame, frame.attribute("attached_to"), source, reading);
  }
}

/// The names of a URDF's links are known only when it has been read.
void readUrdfSource(ModelSource& source, SdfReading& reading) {
  const SdfFile& file = source.element.file();
  source.urdf = std::make_shared<UrdfModel>(reading.readUrdf(file, reading));
  for (const Link& link : source.urdf->model.links) {
    source.frames.add(link.name, {link.X_ML, ""}, "", source.location);
  }
}

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
                             "its pose is relative to itself, through others; the cycle is cut");
    return Pose::Identity();
  }
  frame.is_open = true;
  frame.X_FN = resolve(frame.pose, frame.fallback, frame.location, reading);
  frame.is_open = false;
  return *frame.X_FN;
}

Pose SdfFrames::resolve(const RelativePose& pose, const std::string& fallback,
                        const SourceLocation& location, SdfReading& reading) {
  // Names take precedence over the reserved words: a saved world may have a link called "world".
  if (knows(pose.frame) || (isOwn(pose.frame) && !pose.frame.empty())) {
    return poseOf(pose.frame, reading) * pose.pose;
  }
  const std::string& name = knows(fallback) ? fallback : kOwn;
  if (!pose.frame.empty()) {
    reading.findings.addNote(
        location, "its pose is relative to '" + pose.frame + "', which is not known here; " +
                      (name.empty() ? "the enclosing frame" : "'" + name + "'") + " is taken");
  }
  return poseOf(name, reading) * pose.pose;
}

RelativePose placed(ModelSource& source, SdfReading& reading) {
  RelativePose pose = source.pose;
  if (source.placement_frame.empty()) return pose;
  if (!source.frames.knows(source.placement_frame)) {
    reading.findings.addNote(source.location, "its placement_frame '" + source.placement_frame +
                                                  "' is unknown; its own frame is taken");
    return pose;
  }
  pose.pose = pose.pose * source.frames.poseOf(source.placement_frame, reading).inverse();
  return pose;
}

void fillFrames(ModelSource& source, SdfReading& reading) {
  if (source.kind == ModelSource::Kind::kUrdf) readUrdfSource(source, reading);
  if (source.kind != ModelSource::Kind::kModel) return;
  addOwnFrames(source, reading);
  for (ModelSource& inner : source.models) {
    fillFrames(inner, reading);
    source.frames.add(inner.name, placed(inner, reading), "", inner.location);
    source.frames.addInner(inner.name, inner.merges ? "" : inner.name + "::", inner.frames,
                           reading);
  }
}

}  // namespace synthetic_dataset::world

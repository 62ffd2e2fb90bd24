#include "world/sdf/model_source.h"

#include <utility>

#include "world/urdf/urdf_models.h"

namespace synthetic_dataset::world {
namespace {

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

/// A URDF says what its links are called only when it has been read.
void readUrdfSource(ModelSource& source, SdfReading& reading) {
  const SdfFile& file = source.element.file();
  const ModelText text{file.path.string(), file.path.parent_path(), file.text};
  UrdfReading urdf{text, reading.finder, reading.meshes, reading.shapes, reading.findings};
  source.urdf = std::make_shared<Model>(readUrdfModel(urdf));
  for (const Link& link : source.urdf->links) {
    source.frames.add(link.name, {link.X_ML, ""}, "", source.location);
  }
}

}  // namespace

RelativePose placed(ModelSource& source, SdfReading& reading) {
  RelativePose pose = source.pose;
  if (source.placement_frame.empty()) return pose;
  if (!source.frames.knows(source.placement_frame)) {
    reading.findings.addNote(source.location, "its placement_frame '" + source.placement_frame +
                                                  "' is not known; its own is taken");
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

#include "world/sdf/sdf_state.h"

#include "world/sdf/sdf_values.h"

namespace synthetic_dataset::world {
namespace {

/// The poses of links of nested models are given in the world's frame, too.
void readLinks(const Element& model, const std::string& prefix, const SourceLocation& location,
               SdfReading& reading, SavedModel& saved) {
  for (const Element& link : model.children("link")) {
    if (!hasPose(link)) continue;
    const SourceLocation here = locationOf(link, location);
    saved.X_WL[prefix + link.attribute("name")] = readPose(link, here, reading).pose;
  }
  for (const Element& inner : model.children("model")) {
    readLinks(inner, prefix + inner.attribute("name") + "::", locationOf(inner, location), reading,
              saved);
  }
}

SavedModel readModelState(const Element& model, const SourceLocation& location,
                          SdfReading& reading) {
  SavedModel saved;
  if (hasPose(model)) saved.X_WM = readPose(model, location, reading).pose;
  saved.scale = readVector(model, "scale", saved.scale, location, reading);
  readLinks(model, "", location, reading, saved);
  return saved;
}

}  // namespace

SavedState readState(const Element& world, const SourceLocation& location, SdfReading& reading) {
  SavedState saved;
  for (const Element& state : world.children("state")) {
    const SourceLocation here = locationOf(state, location, state.attribute("world_name"));
    for (const Element& model : state.children("model")) {
      saved.models[model.attribute("name")] =
          readModelState(model, locationOf(model, here), reading);
    }
    for (const Element& light : state.children("light")) {
      if (!hasPose(light)) continue;
      saved.lights[light.attribute("name")] =
          readPose(light, locationOf(light, here), reading).pose;
    }
    for (const Element& each : state.child("insertions").children()) {
      if (each.name() == "model" || each.name() == "light") saved.inserted.push_back(each);
    }
    for (const Element& name : state.child("deletions").children("name")) {
      saved.deleted.insert(name.text());
    }
  }
  return saved;
}

}  // namespace synthetic_dataset::world

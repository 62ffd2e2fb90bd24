#include "world/sdf/sdf_actors.h"

#include <filesystem>
#include <optional>
#include <utility>

#include "synthetic_dataset/errors.h"
#include "world/sdf/sdf_picture_geometry.h"
#include "world/sdf/sdf_values.h"
#include "world/sdf/sdf_visuals.h"

namespace synthetic_dataset::world {
namespace {

/// The animation of a name, else the first one.
Element animationNamed(const Element& actor, const std::string& name) {
  for (const Element& animation : actor.children("animation")) {
    if (animation.attribute("name") == name) return animation;
  }
  return actor.child("animation");
}

Pose startOf(const Element& trajectory, const Pose& X_WA, const SourceLocation& location,
             SdfReading& reading) {
  const Element waypoint = trajectory.child("waypoint");
  return hasPose(waypoint) ? readPose(waypoint, location, reading).pose : X_WA;
}

std::optional<std::filesystem::path> fileOf(const Element& element, const SourceLocation& location,
                                            SdfReading& reading) {
  return findFile("mesh", readText(element, "filename"), element, location, reading);
}

}  // namespace

Model readActor(const Element& actor, const std::string& name, const Pose& X_WA,
                const SourceLocation& location, SdfReading& reading) {
  const Element trajectory = actor.child("script").child("trajectory");
  const Element skin = actor.child("skin");
  Model model;
  model.name = name;
  model.is_static = true;
  model.X_WM = startOf(trajectory, X_WA, location, reading);
  const auto file = fileOf(skin, location, reading);
  if (!file) return model;
  const Element animation = animationNamed(actor, trajectory.attribute("type"));
  MeshRequest request;
  request.file = *file;
  request.scale.setConstant(readNumber(skin, "scale", 1.0, location, reading));
  request.animation = animation ? fileOf(animation, location, reading) : std::nullopt;
  if (reading.survey != nullptr) return model;
  Visual visual;
  visual.name = "skin";
  try {
    visual.surfaces = meshSurfaces(request, std::nullopt, location, reading);
  } catch (const Error& error) {
    reading.missing(location, error.what());
  }
  Link link;
  link.name = "link";
  if (!visual.surfaces.empty()) link.visuals.push_back(std::move(visual));
  model.links.push_back(std::move(link));
  return model;
}

}  // namespace synthetic_dataset::world

#include "world/sdf/sdf_worlds.h"

#include <filesystem>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "synthetic_dataset/errors.h"
#include "world/sdf/sdf_includes.h"
#include "world/sdf/sdf_lights.h"
#include "world/sdf/sdf_models.h"
#include "world/sdf/sdf_picture_geometry.h"
#include "world/sdf/sdf_populations.h"
#include "world/sdf/sdf_reading.h"
#include "world/sdf/sdf_roads.h"
#include "world/sdf/sdf_scene.h"
#include "world/sdf/sdf_state.h"
#include "world/sdf/sdf_values.h"
#include "world/sdf/sdf_visuals.h"

namespace synthetic_dataset::world {
namespace {

/// The animation with this name, else the first one.
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

/// Reads an `<actor>` as a static model: its skin in the first pose of the animation that its
/// trajectory begins with, at the trajectory's first waypoint, as Gazebo shows it at time 0.
/// Without a trajectory, it has its own pose.
/// @param actor  an `<actor>`
/// @param X_WA  its own pose
/// @param location  the actor's
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
    visual.surfaces = meshSurfaces(request, std::nullopt, std::nullopt, location, reading);
  } catch (const Error& error) {
    reading.missing(location, error.what());
  }
  Link link;
  link.name = "link";
  if (!visual.surfaces.empty()) link.visuals.push_back(std::move(visual));
  model.links.push_back(std::move(link));
  return model;
}

using Kind = ModelSource::Kind;

/// Reads the contents of a world.
class WorldReader {
 public:
  WorldReader(const Element& world, const SourceLocation& location, SdfReading& reading)
      : world_(world),
        location_(location),
        reading_(reading),
        saved_(readState(world, location, reading)) {}

  Description read() {
    readGlobals();
    gather(world_);
    for (const Element& each : saved_.inserted) gatherOne(each);
    // A saved world has the populations' models themselves in its state.
    for (const Element& each : world_.children("population")) {
      for (ModelSource& source : readPopulation(each, location_, includes_, reading_)) {
        addSource(std::move(source));
      }
    }
    for (ModelSource& source : sources_) addFrames(source);
    for (ModelSource& source : sources_) readSource(source);
    for (const Element& road : world_.children("road")) {
      description_.models.push_back(readRoad(road, locationOf(road, location_), reading_));
    }
    return std::move(description_);
  }

 private:
  void readGlobals() {
    // Up to SDF 1.5, gravity was part of <physics>.
    const Element owner = world_.has("gravity") ? world_ : world_.child("physics");
    description_.gravity = readVector(owner, "gravity", description_.gravity, location_, reading_);
    const Element scene = world_.child("scene");
    readScene(scene, location_.in("scene"), reading_, description_);
    has_shadows_ = hasShadows(scene, location_.in("scene"), reading_);
    for (const Element& frame : world_.children("frame")) {
      const SourceLocation here = locationOf(frame, location_);
      frames_.add(frame.attribute("name"), readPose(frame, here, reading_),
                  frame.attribute("attached_to"), here);
    }
  }

  void gather(const Element& parent) {
    for (const Element& child : parent.children()) gatherOne(child);
  }

  void gatherOne(const Element& element) {
    const std::string name = element.name();
    if (name == "model") addSource(includes_.modelOf(element, location_));
    if (name == "include") addSource(includes_.followed(element, location_));
    if (name != "light" && name != "actor") return;
    ModelSource source;
    source.kind = name == "light" ? Kind::kLight : Kind::kActor;
    source.element = element;
    source.name = element.attribute("name");
    source.location = locationOf(element, location_);
    source.pose = readPose(element, source.location, reading_);
    addSource(std::move(source));
  }

  void addSource(ModelSource source) {
    if (saved_.deleted.count(source.name) > 0) return;
    if (source.kind != Kind::kNothing) source.name = uniqueName(source);
    sources_.push_back(std::move(source));
  }

  /// Gazebo accepts several models of the same name; labels and settings need to tell them apart.
  std::string uniqueName(const ModelSource& source) {
    std::set<std::string>& names = source.kind == Kind::kLight ? light_names_ : model_names_;
    std::string unique = source.name;
    for (int i = 1; !names.insert(unique).second; ++i) {
      unique = source.name + "_" + std::to_string(i);
    }
    if (unique != source.name) {
      reading_.findings.addNote(
          source.location, "something earlier has its name; it is called '" + unique + "' here");
    }
    return unique;
  }

  void addFrames(ModelSource& source) {
    fillFrames(source, reading_);
    frames_.add(source.name, placed(source, reading_), "", source.location);
    frames_.addInner(source.name, source.name + "::", source.frames, reading_);
  }

  void readSource(ModelSource& source) {
    // Not looked up by name: a model and a light may have the same one.
    const Pose X_WM = frames_.resolve(placed(source, reading_), "", source.location, reading_);
    if (source.kind == Kind::kModel || source.kind == Kind::kUrdf) readModelSource(source, X_WM);
    if (source.kind == Kind::kLight) {
      const auto saved = saved_.lights.find(source.name);
      addLight(readLight(source.element, source.name,
                         saved == saved_.lights.end() ? X_WM : saved->second, source.location,
                         reading_));
    }
    if (source.kind == Kind::kActor) {
      description_.models.push_back(
          readActor(source.element, source.name, X_WM, source.location, reading_));
    }
  }

  void readModelSource(ModelSource& source, const Pose& X_WM) {
    const auto found = saved_.models.find(source.name);
    const SavedModel* saved = found == saved_.models.end() ? nullptr : &found->second;
    ModelContents contents =
        readModel(source, saved != nullptr ? saved->X_WM.value_or(X_WM) : X_WM, saved, reading_);
    description_.models.push_back(std::move(contents.model));
    for (Light& light : contents.lights) addLight(std::move(light));
    std::move(contents.cameras.begin(), contents.cameras.end(),
              std::back_inserter(description_.cameras));
    std::move(contents.lidars.begin(), contents.lidars.end(),
              std::back_inserter(description_.lidars));
  }

  void addLight(Light light) {
    light.casts_shadow = light.casts_shadow && has_shadows_;
    description_.lights.push_back(std::move(light));
  }

  const Element& world_;
  const SourceLocation& location_;
  SdfReading& reading_;
  SavedState saved_;
  SdfIncludes includes_{reading_};
  SdfFrames frames_;
  std::vector<ModelSource> sources_;
  std::set<std::string> model_names_;
  std::set<std::string> light_names_;
  Description description_;
  bool has_shadows_ = true;
};

}  // namespace

Description readWorld(const Element& world, SdfReading& reading) {
  const SourceLocation location(world.file().path.string());
  return WorldReader(world, location, reading).read();
}

}  // namespace synthetic_dataset::world

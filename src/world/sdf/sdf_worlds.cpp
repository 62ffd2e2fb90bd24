#include "world/sdf/sdf_worlds.h"

#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <sdf/Light.hh>
#include <sdf/Model.hh>

#include "world/sdf/sdf_document.h"
#include "world/sdf/sdf_lights.h"
#include "world/sdf/sdf_models.h"
#include "world/sdf/sdf_scene.h"

namespace synthetic_dataset::world {
namespace {

using Poses = std::map<std::string, Pose>;

/// The pose that an element gives in plain numbers: position, roll, pitch, yaw (SDF specification,
/// <pose>).
Pose plainPose(const sdf::ElementPtr& element) {
  std::vector<double> v = numbers(element);
  v.resize(6, 0.0);
  return makePose({v[0], v[1], v[2]}, Eigen::AngleAxisd(v[5], Eigen::Vector3d::UnitZ()) *
                                          Eigen::AngleAxisd(v[4], Eigen::Vector3d::UnitY()) *
                                          Eigen::AngleAxisd(v[3], Eigen::Vector3d::UnitX()));
}

/// Where a saved world's <state> puts its things of one kind ("model", "light").
Poses statePoses(const sdf::World& world, const std::string& kind) {
  Poses poses;
  const sdf::ElementPtr state = descendant(world.Element(), {"state"});
  if (!has(state, kind.c_str())) return poses;
  for (auto element = state->GetElement(kind); element; element = element->GetNextElement(kind)) {
    const sdf::ElementPtr pose = descendant(element, {"pose"});
    if (pose) poses[element->Get<std::string>("name")] = plainPose(pose);
  }
  return poses;
}

void readGlobals(const sdf::World& world, const Place& place, SdfReading& reading,
                 Description& description) {
  description.gravity = toEigen(world.Gravity());
  if (!description.gravity.allFinite()) {
    reading.findings.addError(place.message("gravity has to be finite numbers"));
  }
  readScene(descendant(world.Element(), {"scene"}), place.in("scene"), reading, description);
}

void readModels(const sdf::World& world, const Place& place, SdfReading& reading,
                Description& description) {
  const Poses saved = statePoses(world, "model");
  for (std::size_t i = 0; i < world.ModelCount(); ++i) {
    const sdf::Model& model = *world.ModelByIndex(i);
    if (isStandIn(model)) continue;
    const auto found = saved.find(model.Name());
    const Pose X_WM = found != saved.end()
                          ? found->second
                          : resolve(model.SemanticPose(), place.in("model", model.Name()), reading);
    ModelContents contents = readModel(model, X_WM, place, reading);
    description.models.push_back(std::move(contents.model));
    std::move(contents.lights.begin(), contents.lights.end(),
              std::back_inserter(description.lights));
    std::move(contents.cameras.begin(), contents.cameras.end(),
              std::back_inserter(description.cameras));
  }
}

void readLights(const sdf::World& world, const Place& place, SdfReading& reading,
                Description& description) {
  const Poses saved = statePoses(world, "light");
  for (std::size_t i = 0; i < world.LightCount(); ++i) {
    const sdf::Light& light = *world.LightByIndex(i);
    const Place here = place.inFile(fileOf(light.Element()));
    const auto found = saved.find(light.Name());
    const Pose X_WL = found != saved.end()
                          ? found->second
                          : resolve(light.SemanticPose(), here.in("light", light.Name()), reading);
    description.lights.push_back(readLight(light, light.Name(), X_WL, here, reading));
  }
}

}  // namespace

void readWorld(const sdf::World& world, const Place& place, SdfReading& reading,
               Description& description) {
  readGlobals(world, place, reading, description);
  readModels(world, place, reading, description);
  readLights(world, place, reading, description);
  if (!hasShadows(descendant(world.Element(), {"scene"}))) {
    for (Light& light : description.lights) light.casts_shadow = false;
  }
  for (const char* kind : {"actor", "road", "population"}) {
    if (has(world.Element(), kind)) {
      reading.findings.addNote(place.message(std::string("<") + kind + "> is left out"));
    }
  }
}

}  // namespace synthetic_dataset::world

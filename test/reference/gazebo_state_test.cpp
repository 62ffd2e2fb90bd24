/// The state of worlds in Gazebo 11 before the first step of physics: each model, link, visual and
/// light, and where it is.

#include <cmath>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <yaml-cpp/yaml.h>

#include "reference/reference_worlds.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset {
namespace gazebo_state_test {

using testing::IsEmpty;

constexpr double kTolerance = 1e-6;  // [m], and of rotation matrices' numbers

Pose poseOf(const YAML::Node& node) {
  const auto v = node.as<std::vector<double>>();
  return makePose({v[0], v[1], v[2]}, Eigen::Quaterniond(v[3], v[4], v[5], v[6]).normalized());
}

bool areEqual(const Pose& a, const Pose& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff() <= kTolerance;
}

std::string textOf(const Pose& pose) {
  const Eigen::Quaterniond q(pose.linear());
  std::ostringstream text;
  text << pose.translation().transpose() << " / " << q.w() << " " << q.vec().transpose();
  return text.str();
}

/// Includes a model within a model: Gazebo 11's sdformat makes the included one's links those of
/// the outer one, but gives the models within it to the outer one under their own names.
const std::string kFlattened = "turtlebot3_simulations/turtlebot3_house";

/// Names and poses of everything: "model::link" in the world, "model::link::visual" in its link.
using Things = std::map<std::string, Pose>;

/// Whether a geometry names a mesh that is not among the reference data.
bool lacksMesh(const std::string& geometry, const world::ResourceFinder& finder) {
  std::smatch uri;
  const bool is_mesh = std::regex_search(geometry, uri, std::regex("<uri>([^<]*)</uri>"));
  return is_mesh && !finder.find(uri.str(1), "/nowhere");
}

/// Gazebo 11 gives the full names of models within models: "robot::arm".
void gatherGazebos(const YAML::Node& model, const world::ResourceFinder& finder, Things& things) {
  const auto name = model["name"].as<std::string>();
  for (const YAML::Node& link : model["links"]) {
    const std::string link_name = name + "::" + link["name"].as<std::string>();
    things.emplace("link " + link_name, poseOf(link["pose"]));
    for (const YAML::Node& visual : link["visuals"]) {
      if (lacksMesh(visual["geometry"].as<std::string>(""), finder)) continue;
      things.emplace("visual " + link_name + "::" + visual["name"].as<std::string>(),
                     poseOf(visual["pose"]));
    }
  }
  for (const YAML::Node& inner : model["models"]) gatherGazebos(inner, finder, things);
}

Things thingsOfGazebo(const YAML::Node& state, bool is_model, const world::ResourceFinder& finder) {
  Things things;
  for (const YAML::Node& model : state["models"]) {
    if (model["name"].as<std::string>().rfind("look_camera_", 0) == 0) continue;
    gatherGazebos(model, finder, things);
  }
  for (const YAML::Node& light : state["lights"]) {
    if (is_model) break;  // the sun belongs to the world that the model was put into
    things.emplace("light " + light["name"].as<std::string>(), poseOf(light["pose"]));
  }
  return things;
}

Things thingsOf(const world::Description& world) {
  Things things;
  for (const world::Model& model : world.models) {
    for (const world::Link& link : model.links) {
      const std::string name = model.name + "::" + link.name;
      things.emplace("link " + name, model.X_WM * link.X_ML);
      for (const world::Visual& visual : link.visuals) {
        things.emplace("visual " + name + "::" + visual.name, visual.X_LV);
      }
    }
  }
  for (const world::Light& light : world.lights) things.emplace("light " + light.name, light.X_WL);
  return things;
}

std::vector<std::string> differences(const Things& gazebos, const Things& ours) {
  std::vector<std::string> result;
  for (const auto& [name, pose] : gazebos) {
    const auto found = ours.find(name);
    if (found == ours.end()) {
      result.push_back(name + ": missing");
    } else if (!areEqual(found->second, pose)) {
      result.push_back(name + ": Gazebo " + textOf(pose) + ", here " + textOf(found->second));
    }
  }
  return result;
}

TEST(GazeboState, HasEverythingWhereItIsHere) {
  for (const test::ReferenceWorld& world : test::referenceWorlds()) {
    if (world.name == kFlattened) continue;
    try {
      const world::Description description = test::loadReferenceWorld(world);
      const bool is_model = world.name.rfind("models/", 0) == 0;
      const YAML::Node state = YAML::LoadFile((world.reference / "state.json").string());
      EXPECT_THAT(differences(thingsOfGazebo(state, is_model, test::finderFor(world.root)),
                              thingsOf(description)),
                  IsEmpty())
          << world.name;
    } catch (const Error& error) {
      ADD_FAILURE() << world.name << ": " << error.what();
    }
  }
}

}  // namespace gazebo_state_test
}  // namespace synthetic_dataset

/// Worlds and models of the reference data, against libsdformat if it reads them: each pose, shape,
/// colour, light and camera is compared with what this package reads.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <sdf/sdf.hh>

#include <gmock/gmock.h>

#include "reference/reference_folder.h"
#include "reference/reference_worlds.h"
#include "synthetic_dataset/errors.h"
#include "world/camera_frames.h"
#include "world/world_loader.h"

namespace synthetic_dataset {
namespace sdformat_oracle_test {

namespace fs = std::filesystem;

using testing::IsEmpty;

/// The numbers that describe each thing of a file, by name.
using Facts = std::map<std::string, std::vector<double>>;

constexpr double kTolerance = 1e-9;

template <class Pose3>
Pose toPose(const Pose3& pose) {
  return makePose(
      {pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z()},
      Eigen::Quaterniond(pose.Rot().W(), pose.Rot().X(), pose.Rot().Y(), pose.Rot().Z()));
}

std::vector<double> numbersOf(const Pose& pose) {
  return {pose.matrix().data(), pose.matrix().data() + 16};
}

template <class Color>
std::vector<double> coloursOf(const Color& colour) {
  return {colour.R(), colour.G(), colour.B()};
}

template <class Vector>
std::vector<double> vectorOf(const Vector& v) {
  return {v.X(), v.Y(), v.Z()};
}

Pose resolved(const sdf::SemanticPose& pose) {
  auto result = pose.RawPose();
  static_cast<void>(pose.Resolve(result));
  return toPose(result);
}

/// Gathers libsdformat's facts; links of models within models are called "inner::link".
class Oracle {
 public:
  Facts facts;

  void addModel(const sdf::Model& model, const Pose& X_WM, const std::string& name) {
    for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
      addLink(*model.LinkByIndex(i), X_WM, name + "::");
    }
    for (std::uint64_t i = 0; i < model.ModelCount(); ++i) {
      const sdf::Model& inner = *model.ModelByIndex(i);
      addModel(inner, X_WM * resolved(inner.SemanticPose()), name + "::" + inner.Name());
    }
  }

  void addLight(const sdf::Light& light, const Pose& X_WL, const std::string& name) {
    facts["light " + name] = numbersOf(X_WL);
    facts["diffuse of light " + name] = coloursOf(light.Diffuse());
    facts["specular of light " + name] = coloursOf(light.Specular());
    if (light.Type() != sdf::LightType::POINT) {
      facts["direction of light " + name] = vectorOf(light.Direction());
    }
    facts["shadow of light " + name] = {light.CastShadows() ? 1.0 : 0.0};
    // Directional light is not attenuated.
    if (light.Type() != sdf::LightType::DIRECTIONAL && light.Element()->HasElement("attenuation")) {
      facts["attenuation of light " + name] = {
          light.AttenuationRange(), light.ConstantAttenuationFactor(),
          light.LinearAttenuationFactor(), light.QuadraticAttenuationFactor()};
    }
  }

 private:
  void addLink(const sdf::Link& link, const Pose& X_WM, const std::string& scope) {
    const std::string name = scope + link.Name();
    const Pose X_WL = X_WM * resolved(link.SemanticPose());
    facts["link " + name] = numbersOf(X_WL);
    for (std::uint64_t i = 0; i < link.VisualCount(); ++i) {
      const sdf::Visual& visual = *link.VisualByIndex(i);
      if (visual.Transparency() >= 1.0F) continue;
      addShape("visual " + name + "::" + visual.Name(), resolved(visual.SemanticPose()),
               *visual.Geom());
    }
    for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) {
      const sdf::Collision& collision = *link.CollisionByIndex(i);
      addShape("collision " + name + "::" + collision.Name(), resolved(collision.SemanticPose()),
               *collision.Geom());
    }
    for (std::uint64_t i = 0; i < link.LightCount(); ++i) {
      const sdf::Light& light = *link.LightByIndex(i);
      addLight(light, X_WL * resolved(light.SemanticPose()), name + "::" + light.Name());
    }
    for (std::uint64_t i = 0; i < link.SensorCount(); ++i) {
      addCamera(*link.SensorByIndex(i), X_WL, name + "::");
    }
  }

  /// The full lengths along the axes; only for simple shapes.
  void addShape(const std::string& name, const Pose& X_LS, const sdf::Geometry& geometry) {
    std::vector<double> size;
    if (const sdf::Box* box = geometry.BoxShape()) size = vectorOf(box->Size());
    if (const sdf::Sphere* sphere = geometry.SphereShape()) size.assign(3, 2.0 * sphere->Radius());
    if (const sdf::Cylinder* cylinder = geometry.CylinderShape()) {
      size = {2.0 * cylinder->Radius(), 2.0 * cylinder->Radius(), cylinder->Length()};
    }
    if (size.empty()) return;
    facts[name] = numbersOf(X_LS);
    facts["size of " + name] = size;
  }

  void addCamera(const sdf::Sensor& sensor, const Pose& X_WL, const std::string& scope) {
    const sdf::Camera* camera = sensor.CameraSensor();
    if (camera == nullptr || sensor.Type() != sdf::SensorType::CAMERA) return;
    facts["camera " + scope + sensor.Name()] =
        numbersOf(X_WL * resolved(sensor.SemanticPose()) * toPose(camera->RawPose()) *
                  world::opticalInBody());
    facts["image of camera " + scope + sensor.Name()] = {
        static_cast<double>(camera->ImageWidth()), static_cast<double>(camera->ImageHeight())};
  }
};

std::vector<double> extentOf(const world::Mesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& position : mesh.positions) box.extend(position);
  const Eigen::Vector3d size = box.sizes().cast<double>();
  return {size.x(), size.y(), size.z()};
}

struct ExtentOf {
  std::vector<double> operator()(const world::BoxShape& box) const {
    return {box.size.x(), box.size.y(), box.size.z()};
  }
  std::vector<double> operator()(const world::SphereShape& sphere) const {
    return {2.0 * sphere.radius, 2.0 * sphere.radius, 2.0 * sphere.radius};
  }
  std::vector<double> operator()(const world::CylinderShape& cylinder) const {
    return {2.0 * cylinder.radius, 2.0 * cylinder.radius, cylinder.length};
  }
  std::vector<double> operator()(const world::PlaneShape&) const { return {}; }
  std::vector<double> operator()(const world::MeshShape&) const { return {}; }
};

std::vector<double> numbersOf(const Eigen::Vector3f& v) { return {v.x(), v.y(), v.z()}; }

/// This package's facts, under the same names. Lights are taken from Gazebo's shadows setting back.
Facts factsOf(const world::Description& world) {
  Facts facts;
  for (const world::Model& model : world.models) {
    for (const world::Link& link : model.links) {
      const std::string name = model.name + "::" + link.name;
      facts["link " + name] = numbersOf(model.X_WM * link.X_ML);
      for (const world::Visual& visual : link.visuals) {
        facts["visual " + name + "::" + visual.name] = numbersOf(visual.X_LV);
        facts["size of visual " + name + "::" + visual.name] = extentOf(*visual.surfaces[0].mesh);
      }
      for (const world::Collision& collision : link.collisions) {
        facts["collision " + name + "::" + collision.name] = numbersOf(collision.X_LC);
        facts["size of collision " + name + "::" + collision.name] =
            std::visit(ExtentOf{}, collision.shape);
      }
    }
  }
  for (const world::Light& light : world.lights) {
    facts["light " + light.name] = numbersOf(light.X_WL);
    facts["diffuse of light " + light.name] = numbersOf(light.diffuse);
    facts["specular of light " + light.name] = numbersOf(light.specular);
    facts["direction of light " + light.name] = {light.direction_L.x(), light.direction_L.y(),
                                                 light.direction_L.z()};
    facts["shadow of light " + light.name] = {light.casts_shadow ? 1.0 : 0.0};
    facts["attenuation of light " + light.name] = {light.range, light.attenuation_constant,
                                                   light.attenuation_linear,
                                                   light.attenuation_quadratic};
  }
  for (const world::CameraSensor& camera : world.cameras) {
    facts["camera " + camera.name] = numbersOf(camera.X_WC);
    facts["image of camera " + camera.name] = {static_cast<double>(camera.camera.width()),
                                               static_cast<double>(camera.camera.height())};
  }
  return facts;
}

/// Meshes have vertices of single precision, and round ones have their corners on the circle only.
bool areEqual(const std::string& name, double a, double b) {
  const bool is_mesh = name.rfind("size of visual", 0) == 0;
  return std::abs(a - b) <= (is_mesh ? 0.02 * std::max(1e-3, std::abs(a)) : kTolerance);
}

std::vector<std::string> differences(const Facts& oracle, const Facts& ours) {
  std::vector<std::string> result;
  for (const auto& [name, numbers] : oracle) {
    const auto found = ours.find(name);
    if (found == ours.end()) {
      result.push_back(name + ": missing here");
      continue;
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (i < found->second.size() && areEqual(name, numbers[i], found->second[i])) continue;
      result.push_back(name + ": another number at " + std::to_string(i));
      break;
    }
  }
  return result;
}

/// libsdformat's facts of a file; none if it reports an error.
Facts oracleOf(const std::string& file, const world::ResourceFinder& finder) {
  sdf::setFindCallback([&](const std::string& uri) {
    const auto found = finder.find(uri, fs::path(file).parent_path());
    return found ? found->string() : "";
  });
  sdf::Root root;
  Oracle oracle;
  try {
    if (!root.Load(file).empty()) return {};
  } catch (const std::exception&) {
    return {};
  }
  if (const sdf::World* world = root.WorldByIndex(0)) {
    if (world->Element()->HasElement("state")) return {};  // which libsdformat does not apply
    for (std::uint64_t i = 0; i < world->ModelCount(); ++i) {
      const sdf::Model& model = *world->ModelByIndex(i);
      oracle.addModel(model, resolved(model.SemanticPose()), model.Name());
    }
    for (std::uint64_t i = 0; i < world->LightCount(); ++i) {
      const sdf::Light& light = *world->LightByIndex(i);
      oracle.addLight(light, resolved(light.SemanticPose()), light.Name());
    }
  } else if (const sdf::Model* model = root.Model()) {
    oracle.addModel(*model, toPose(model->RawPose()), model->Name());
  }
  return oracle.facts;
}

std::vector<std::string> sdfFilesBelow(const fs::path& root) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".world" || extension == ".sdf") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class SdformatOracle : public testing::TestWithParam<std::string> {};

TEST_P(SdformatOracle, SaysTheSame) {
  const fs::path root = test::referenceFolder() / GetParam();
  const world::ResourceFinder finder = test::finderFor(root);
  world::LoadOptions options;
  options.on_missing_asset = world::OnMissingAsset::kWarn;
  std::ostringstream console;  // libsdformat's own remarks
  std::streambuf* const cerr_buffer = std::cerr.rdbuf(console.rdbuf());
  std::size_t compared = 0;
  for (const std::string& file : sdfFilesBelow(root)) {
    const Facts oracle = oracleOf(file, finder);
    if (oracle.empty()) continue;
    ++compared;
    const Facts ours = factsOf(world::loadWorld(file, finder, options));
    EXPECT_THAT(differences(oracle, ours), IsEmpty()) << file;
  }
  std::cerr.rdbuf(cerr_buffer);
  RecordProperty("files", static_cast<int>(compared));
  EXPECT_GT(compared, 0U);
}

INSTANTIATE_TEST_SUITE_P(Files, SdformatOracle,
                         testing::Values("models/gazebo", "gazebo/chart", "worlds/aws_bookstore",
                                         "worlds/aws_small_warehouse", "worlds/pal_gazebo_worlds",
                                         "worlds/px4_sitl_gazebo", "worlds/rotors_simulator",
                                         "worlds/turtlebot3_simulations"));

}  // namespace sdformat_oracle_test
}  // namespace synthetic_dataset

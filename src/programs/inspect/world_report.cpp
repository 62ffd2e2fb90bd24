#include "programs/inspect/world_report.h"

#include <sstream>
#include <vector>

#include "run/pictures/model_portrait.h"
#include "run/setup/package_index.h"
#include "synthetic_dataset/label_text.h"
#include "world/files/resource_finder.h"
#include "world/world_loader.h"

namespace synthetic_dataset::programs {
namespace {

namespace fs = std::filesystem;

std::string lengths(const Eigen::Vector3d& size) {
  const int decimals = size.maxCoeff() < 0.1 ? 4 : 2;
  return fixed(size.x(), decimals) + " x " + fixed(size.y(), decimals) + " x " +
         fixed(size.z(), decimals) + " m";
}

std::string placeText(const Eigen::Vector3d& p_W) {
  return "at [" + fixed(p_W.x(), 2) + ", " + fixed(p_W.y(), 2) + ", " + fixed(p_W.z(), 2) + "]";
}

const char* typeOf(const world::Light& light) {
  switch (light.type) {
    case world::LightType::kDirectional:
      return "directional";
    case world::LightType::kPoint:
      return "point";
    case world::LightType::kSpot:
      return "spot";
  }
  return "";
}

Value vectorValue(const Eigen::Vector3d& vector) {
  return Value(Value::List{Value(vector.x()), Value(vector.y()), Value(vector.z())});
}

Value linkValue(const world::Model& model, const world::Link& link) {
  Value::Map map = {{"name", Value(link.name)},
                    {"position", vectorValue(link.X_ML.translation())},
                    {"visuals", Value(static_cast<std::int64_t>(link.visuals.size()))},
                    {"collisions", Value(static_cast<std::int64_t>(link.collisions.size()))}};
  if (link.parent) map["parent"] = Value(model.links[*link.parent].name);
  if (!link.moving_joint.empty()) map["joint"] = Value(link.moving_joint);
  return Value(map);
}

Value modelValue(const world::Model& model) {
  Value::List links;
  for (const world::Link& link : model.links) links.push_back(linkValue(model, link));
  Value::Map map = {{"name", Value(model.name)},
                    {"static", Value(model.is_static)},
                    {"position", vectorValue(model.X_WM.translation())},
                    {"links", Value(links)}};
  const Eigen::AlignedBox3d bounds = run::visibleBounds(model, model.X_WM);
  if (!bounds.isEmpty()) {
    map["low"] = vectorValue(bounds.min());
    map["high"] = vectorValue(bounds.max());
  }
  return Value(map);
}

void printModel(const world::Model& model, bool with_links, std::ostream& out) {
  const Eigen::AlignedBox3d bounds = run::visibleBounds(model, model.X_WM);
  out << "model " << model.name << ": "
      << (bounds.isEmpty() ? "nothing to see" : lengths(bounds.sizes())) << ", "
      << placeText(model.X_WM.translation()) << (model.is_static ? ", static" : "") << ", "
      << model.links.size() << (model.links.size() == 1 ? " link\n" : " links\n");
  for (std::size_t i = 0; with_links && i < model.links.size(); ++i) {
    const world::Link& link = model.links[i];
    out << "  link " << link.name;
    if (link.parent) out << ", on " << model.links[*link.parent].name;
    if (!link.moving_joint.empty()) out << " by the joint " << link.moving_joint;
    out << (link.visuals.empty() ? ", nothing to see\n" : "\n");
  }
}

}  // namespace

std::vector<std::string> modelFoldersAround(const fs::path& file) {
  std::vector<std::string> folders;
  const fs::path folder = fs::weakly_canonical(file).parent_path();
  for (const fs::path& models : {folder / "models", folder.parent_path() / "models"}) {
    if (fs::is_directory(models)) folders.push_back(models.string());
  }
  return folders;
}

world::Description readForInspection(const fs::path& given) {
  const bool is_uri = given.string().find("://") != std::string::npos;
  const fs::path file = is_uri ? given : fs::weakly_canonical(fs::absolute(given));
  const run::RosPackageIndex packages;
  std::vector<std::string> folders = modelFoldersAround(file);
  folders.push_back(file.parent_path().string());
  folders.push_back(file.parent_path().parent_path().string());
  const world::ResourceFinder finder(folders, packages.finder(), packages.exports());
  world::LoadOptions options;
  options.on_missing_asset = world::OnMissingAsset::kWarn;
  return world::loadWorld(file.string(), finder, options);
}

std::string worldText(const world::Description& description) {
  std::ostringstream out;
  const bool is_model = description.models.size() == 1;
  for (const world::Model& model : description.models) printModel(model, is_model, out);
  for (const world::Light& light : description.lights) {
    out << "light " << light.name << ": " << typeOf(light);
    if (light.type != world::LightType::kDirectional) {
      out << ", " << placeText(light.X_WL.translation()) << ", reaches " << fixed(light.range, 1)
          << " m";
    }
    out << (light.casts_shadow ? ", casts shadows\n" : "\n");
  }
  if (description.lights.empty() && !is_model) out << "no light\n";
  for (const world::CameraSensor& camera : description.cameras) {
    out << "camera " << camera.name << ": " << camera.camera.width() << " x "
        << camera.camera.height() << " (camera/sensor)\n";
  }
  for (const world::LidarSensor& lidar : description.lidars) {
    out << "lidar " << lidar.name << ": " << lidar.elevation.count << " x " << lidar.azimuth.count
        << " (lidars/NAME/sensor)\n";
  }
  for (const std::string& note : description.notes) out << "note: " << note << '\n';
  return out.str();
}

Value worldValue(const world::Description& description) {
  Value::List models;
  for (const world::Model& model : description.models) models.push_back(modelValue(model));
  Value::List lights;
  for (const world::Light& light : description.lights) {
    lights.emplace_back(Value::Map{{"name", Value(light.name)},
                                   {"type", Value(typeOf(light))},
                                   {"position", vectorValue(light.X_WL.translation())},
                                   {"range", Value(light.range)},
                                   {"casts_shadows", Value(light.casts_shadow)}});
  }
  Value::List cameras;
  for (const world::CameraSensor& camera : description.cameras) {
    cameras.emplace_back(Value::Map{{"name", Value(camera.name)},
                                    {"width", Value(camera.camera.width())},
                                    {"height", Value(camera.camera.height())}});
  }
  Value::List lidars;
  for (const world::LidarSensor& lidar : description.lidars) {
    lidars.emplace_back(Value::Map{{"name", Value(lidar.name)},
                                   {"rings", Value(lidar.elevation.count)},
                                   {"columns", Value(lidar.azimuth.count)}});
  }
  Value::List notes;
  for (const std::string& note : description.notes) notes.emplace_back(note);
  return Value(Value::Map{{"kind", Value("world")},
                          {"models", Value(models)},
                          {"lights", Value(lights)},
                          {"cameras", Value(cameras)},
                          {"lidars", Value(lidars)},
                          {"notes", Value(notes)}});
}

}  // namespace synthetic_dataset::programs

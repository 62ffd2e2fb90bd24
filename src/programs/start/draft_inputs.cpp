#include "programs/start/draft_inputs.h"

#include <algorithm>
#include <cctype>
#include <exception>
#include <filesystem>

#include "base/input_file.h"
#include "programs/inspect/world_report.h"
#include "run/pictures/model_portrait.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::programs {
namespace {

namespace fs = std::filesystem;

/// The largest side of a model; 0 if it cannot be read, which the run's check will explain.
double sizeOf(const std::string& model) {
  try {
    const auto bounds = run::visibleBounds(readForInspection(model));
    return bounds.isEmpty() ? 0.0 : bounds.sizes().maxCoeff();
  } catch (const std::exception&) {
    return 0.0;
  }
}

/// An object's name from its model's file: "husky" for husky.urdf.xacro and for husky/model.sdf.
std::string nameOfFile(const std::string& model) {
  const fs::path path(model);
  std::string name = path.filename().string();
  name = name.substr(0, name.find('.'));
  if (name == "model") name = path.parent_path().filename().string();
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name.empty() ? "object" : name;
}

}  // namespace

std::string absoluteFile(const std::string& name) {
  const bool is_uri = name.find("://") != std::string::npos;
  if (!is_uri && !fs::exists(name)) {
    throw Error("'" + name + "': no such file" + base::didYouMeanFile(name));
  }
  return is_uri ? name : fs::absolute(name).lexically_normal().string();
}

DraftInputs readDraftInputs(const std::vector<std::string>& bag_files,
                            const std::optional<std::string>& world) {
  DraftInputs inputs;
  for (const std::string& bag : bag_files) inputs.bag_files.push_back(absoluteFile(bag));
  inputs.contents = motion::readContents(inputs.bag_files);
  if (!world) return inputs;
  inputs.world = absoluteFile(*world);
  inputs.model_folders = modelFoldersAround(*inputs.world);
  return inputs;
}

DraftInputs::Object objectOf(const std::string& name, const std::string& model) {
  const std::string file = absoluteFile(model);
  return {name, file, sizeOf(file)};
}

std::vector<DraftInputs::Object> objectsOf(const std::vector<std::string>& models,
                                           const motion::BagContents& contents) {
  std::vector<std::string> free;
  for (const motion::RobotFrame& robot : motion::robotFrames(contents)) {
    free.push_back(objectNameOf(robot));
  }
  std::vector<DraftInputs::Object> objects;
  for (const std::string& model : models) {
    std::string name = nameOfFile(model);
    if (!free.empty()) {
      const std::string robot = nearestName(name, free).value_or(free.front());
      free.erase(std::find(free.begin(), free.end(), robot));
      name = robot;
    }
    objects.push_back(objectOf(name, model));
  }
  return objects;
}

}  // namespace synthetic_dataset::programs

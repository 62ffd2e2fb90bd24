#include <utility>

#include "base/diagnostics.h"
#include "base/yaml_value.h"
#include "scene/calibration/calibration_format.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::scene {
namespace {

/// A lens model of camodocal: the names of its numbers in their groups, in the order of Distortion
/// and of fx, fy, cx, cy (camera_models/src/camera_models/*.cc of
/// https://github.com/hengli/camodocal).
struct CamodocalModel {
  const char* name;
  const char* distortion_model;
  std::vector<std::pair<const char*, const char*>> coefficients;  ///< group, name
  std::vector<const char*> intrinsics;                            ///< in projection_parameters
};

const std::vector<CamodocalModel>& camodocalModels() {
  static const std::vector<CamodocalModel> models = {
      {"PINHOLE",
       "plumb_bob",
       {{"distortion_parameters", "k1"},
        {"distortion_parameters", "k2"},
        {"distortion_parameters", "p1"},
        {"distortion_parameters", "p2"}},
       {"fx", "fy", "cx", "cy"}},
      {"MEI",
       "omnidirectional",
       {{"mirror_parameters", "xi"},
        {"distortion_parameters", "k1"},
        {"distortion_parameters", "k2"},
        {"distortion_parameters", "p1"},
        {"distortion_parameters", "p2"}},
       {"gamma1", "gamma2", "u0", "v0"}},
      {"KANNALA_BRANDT",
       "equidistant",
       {{"projection_parameters", "k2"},
        {"projection_parameters", "k3"},
        {"projection_parameters", "k4"},
        {"projection_parameters", "k5"}},
       {"mu", "mv", "u0", "v0"}},
  };
  return models;
}

const CamodocalModel& modelNamed(const std::string& name) {
  for (const CamodocalModel& model : camodocalModels()) {
    if (name == model.name) return model;
  }
  throw Error("a calibration of camodocal with model_type " + name +
              ", which is not drawn; it should be PINHOLE, MEI or KANNALA_BRANDT");
}

Value::Map infoOf(const Value& root) {
  Parameters parameters(root);
  const CamodocalModel& model = modelNamed(parameters.required<std::string>("model_type"));
  Value::List coefficients;
  for (const auto& [group, name] : model.coefficients) {
    coefficients.emplace_back(parameters.group(group).required<double>(name));
  }
  std::vector<double> k;
  for (const char* name : model.intrinsics) {
    k.push_back(parameters.group("projection_parameters").required<double>(name));
  }
  Value::Map info = {{"image_width", Value(parameters.required<int>("image_width"))},
                     {"image_height", Value(parameters.required<int>("image_height"))},
                     {"distortion_model", Value(model.distortion_model)},
                     {"distortion_coefficients", Value(coefficients)}};
  if (!parameters.errors().empty()) throw ErrorList(parameters.errors());
  info["camera_matrix"] = Value(Value::List{k[0], 0.0, k[2], 0.0, k[1], k[3], 0.0, 0.0, 1.0});
  return info;
}

bool recognisesCamodocal(const std::string& text) {
  return text.find("model_type:") != std::string::npos &&
         text.find("projection_parameters:") != std::string::npos;
}

std::vector<ListedCamera> readCamodocalCalibration(const std::string& text,
                                                   const std::string& file) {
  const Value root = base::parseYaml(text, file);
  return base::namingPlace(file, [&] { return std::vector<ListedCamera>{{"", infoOf(root)}}; });
}

}  // namespace

const CalibrationFormat kCamodocalFormat = {recognisesCamodocal, readCamodocalCalibration};

}  // namespace synthetic_dataset::scene

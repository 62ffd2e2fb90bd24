#include <algorithm>
#include <utility>

#include "base/diagnostics.h"
#include "base/yaml_value.h"
#include "scene/calibration/calibration_format.h"
#include "scene/calibration/calibration_names.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::scene {
namespace {

/// https://github.com/ethz-asl/kalibr/wiki/supported-models: a camera model of Kalibr, and what its
/// `intrinsics` are.
struct KalibrModel {
  const char* name;
  std::size_t own_count;  ///< of the numbers before fu, fv, pu, pv
  const char* intrinsics;
};

constexpr KalibrModel kKalibrModels[] = {
    {"pinhole", 0, "4 (fu, fv, pu, pv)"},
    {"omni", 1, "5 (xi, fu, fv, pu, pv)"},
    {"ds", 2, "6 (xi, alpha, fu, fv, pu, pv)"},
};

/// The entries of a camera in the camchain.
struct KalibrCamera {
  std::string camera_model;
  std::string distortion_model;
  std::vector<double> intrinsics;
  std::vector<double> distortion;
  std::vector<double> resolution;
};

bool isNone(const KalibrCamera& camera) {
  return camera.distortion_model == "none" || camera.distortion_model.empty();
}

bool isRadialTangential(const KalibrCamera& camera) {
  return camera.distortion_model == "radtan" || camera.distortion_model == "radial-tangential";
}

const KalibrModel& modelOf(const KalibrCamera& camera) {
  for (const KalibrModel& model : kKalibrModels) {
    if (camera.camera_model == model.name) return model;
  }
  throw Error("a Kalibr camchain with model " + camera.camera_model +
              ", which is not drawn; camera_model should be pinhole, omni or ds");
}

/// The name and the coefficients of the lens, in the form used by makeDistortion().
std::pair<std::string, std::vector<double>> lensOf(const KalibrCamera& camera,
                                                   const KalibrModel& model) {
  const auto own_end = camera.intrinsics.begin() + static_cast<std::ptrdiff_t>(model.own_count);
  std::vector<double> own(camera.intrinsics.begin(), own_end);
  const bool is_bent =
      !isNone(camera) && std::any_of(camera.distortion.begin(), camera.distortion.end(),
                                     [](double k) { return k != 0.0; });
  if (model.own_count == 0) {
    const std::string name = isNone(camera) ? "none" : camera.distortion_model;
    return {name, isNone(camera) ? std::vector<double>{} : camera.distortion};
  }
  const bool is_omni = model.own_count == 1;
  if (is_bent && !(is_omni && isRadialTangential(camera))) {
    throw Error("a Kalibr camchain with model " + camera.camera_model + " and distortion_model " +
                camera.distortion_model + ", which is not drawn; distortion_model should be " +
                (is_omni ? "radtan or none" : "none"));
  }
  if (is_bent) own.insert(own.end(), camera.distortion.begin(), camera.distortion.end());
  return {is_omni ? "omnidirectional" : "double_sphere", own};
}

Value listOf(const std::vector<double>& numbers) {
  return Value(Value::List(numbers.begin(), numbers.end()));
}

Value::Map infoOf(const KalibrCamera& camera) {
  const KalibrModel& model = modelOf(camera);
  if (camera.intrinsics.size() != model.own_count + 4) {
    throw Error("intrinsics: found " + std::to_string(camera.intrinsics.size()) +
                " numbers; with camera_model " + camera.camera_model + " it should be " +
                model.intrinsics);
  }
  if (camera.resolution.size() != 2) {
    throw Error("resolution: found " + std::to_string(camera.resolution.size()) +
                " numbers; it should be 2 (width, height)");
  }
  const auto [name, coefficients] = lensOf(camera, model);
  const auto k = camera.intrinsics.end() - 4;
  return {{"image_width", pixelCount(camera.resolution[0])},
          {"image_height", pixelCount(camera.resolution[1])},
          {"camera_matrix", listOf({k[0], 0.0, k[2], 0.0, k[1], k[3], 0.0, 0.0, 1.0})},
          {"distortion_model", Value(name)},
          {"distortion_coefficients", listOf(coefficients)}};
}

std::vector<double> numbersOf(Parameters& group, const std::string& name,
                              const std::string& other_name) {
  if (!group.has(name) && group.has(other_name)) {
    return group.required<std::vector<double>>(other_name);
  }
  return group.required<std::vector<double>>(name);
}

KalibrCamera readKalibrCamera(const Value::Map& map) {
  Parameters group{Value(map)};
  KalibrCamera camera;
  camera.camera_model = group.optional<std::string>("camera_model", "pinhole");
  camera.distortion_model = group.optional<std::string>("distortion_model", "none");
  const std::size_t hyphen = camera.camera_model.find('-');  // pinhole-radtan
  if (hyphen != std::string::npos) {
    camera.distortion_model = camera.camera_model.substr(hyphen + 1);
    camera.camera_model.resize(hyphen);
  }
  camera.intrinsics = numbersOf(group, "intrinsics", "intrinsics");
  if (!isNone(camera)) {
    camera.distortion = numbersOf(group, "distortion_coeffs", "distortion_coefficients");
  }
  camera.resolution = numbersOf(group, "resolution", "resolution");
  if (!group.errors().empty()) throw ErrorList(group.errors());
  return camera;
}

/// X_AB from a list of four rows; nothing if the map has no such entry.
std::optional<Pose> poseOf(const Value::Map& map, const std::string& name) {
  const auto found = map.find(name);
  if (found == map.end()) return std::nullopt;
  Parameters group(Value(Value::Map{{name, flatMatrix(found->second)}}));
  const auto m = group.required<std::vector<double>>(name);
  if (!group.errors().empty()) throw ErrorList(group.errors());
  if (m.size() != 16) {
    throw Error(name + ": found " + std::to_string(m.size()) +
                " numbers; it should be 4 rows of 4");
  }
  Eigen::Matrix3d R;
  R << m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10];
  return makePose({m[3], m[7], m[11]}, Eigen::Quaterniond(R));
}

bool isOfKalibr(const Value& value) {
  const auto* map = value.as<Value::Map>();
  return map != nullptr && map->count("intrinsics") != 0 &&
         (map->count("camera_model") != 0 || map->count("distortion_coeffs") != 0);
}

/// Without parsing it: `intrinsics` next to `camera_model`, where keys may begin.
bool recognisesKalibr(const std::string& text) {
  const auto has = [&](const std::string& name) {
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
      const bool begins = at == 0 || std::string(" \t\n{,").find(text[at - 1]) != std::string::npos;
      if (begins) return true;
    }
    return false;
  };
  return has("intrinsics:") && (has("camera_model:") || has("distortion_coeffs:"));
}

/// Each camera's extrinsics are relative to the camera before it: p_n = T_cn_cnm1 p_(n - 1).
std::vector<ListedCamera> readKalibrCalibration(const std::string& text, const std::string& file) {
  const Value root = base::parseYaml(text, file);
  const auto* map = root.as<Value::Map>();
  std::vector<ListedCamera> cameras;
  if (isOfKalibr(root)) {
    cameras.push_back(
        {"", base::namingPlace(file, [&] { return infoOf(readKalibrCamera(*map)); })});
    return cameras;
  }
  std::optional<Pose> X_BC;
  for (const Value::Map::value_type& entry : map != nullptr ? *map : Value::Map()) {
    if (!isOfKalibr(entry.second)) continue;
    const auto& own = *entry.second.as<Value::Map>();
    base::namingPlace(file + ": " + entry.first, [&] {
      const auto T = poseOf(own, "T_cn_cnm1");
      if (cameras.empty()) {
        X_BC = Pose::Identity();
      } else {
        X_BC = X_BC && T ? std::optional<Pose>(*X_BC * T->inverse()) : std::nullopt;
      }
      cameras.push_back({entry.first, infoOf(readKalibrCamera(own)), X_BC});
    });
  }
  if (cameras.empty()) {
    throw Error(file +
                ": found no camera; a Kalibr camchain should have cam0 with camera_model, "
                "intrinsics and resolution");
  }
  return cameras;
}

}  // namespace

const CalibrationFormat kKalibrFormat = {recognisesKalibr, readKalibrCalibration};

}  // namespace synthetic_dataset::scene

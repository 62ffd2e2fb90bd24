#include "scene/calibration/calibration_file.h"

#include <algorithm>
#include <utility>

#include "base/diagnostics.h"
#include "base/input_file.h"
#include "base/yaml_value.h"
#include "scene/calibration/calibration_format.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::scene {
namespace {

std::vector<ListedCamera> listedCameras(const std::string& text, const std::string& file) {
  for (const CalibrationFormat* format :
       {&kOstFormat, &kKalibrFormat, &kCamodocalFormat, &kOpenCvFormat}) {
    if (format->recognises(text)) return format->read(text, file);
  }
  return kRosFormat.read(text, file);
}

std::string namesOf(const std::vector<ListedCamera>& cameras) {
  std::string text;
  for (const ListedCamera& camera : cameras) text += (text.empty() ? "" : ", ") + camera.name;
  return text;
}

const ListedCamera& find(const std::vector<ListedCamera>& cameras, const std::string& name,
                         const std::string& setting) {
  const auto found = std::find_if(cameras.begin(), cameras.end(),
                                  [&](const ListedCamera& each) { return each.name == name; });
  if (found != cameras.end()) return *found;
  std::vector<std::string> names;
  for (const ListedCamera& camera : cameras) names.push_back(camera.name);
  const bool has_names = cameras.size() > 1 || !cameras.front().name.empty();
  throw Error(setting + ": found '" + name + "'; the file has " +
              (has_names ? "the cameras " + namesOf(cameras) : "one camera without a name") +
              didYouMean(name, names));
}

const ListedCamera& chosenFrom(const std::vector<ListedCamera>& cameras,
                               const CalibrationChoice& choice) {
  if (choice.camera) return find(cameras, *choice.camera, "info_camera");
  if (cameras.size() == 1) return cameras.front();
  throw Error("it has the cameras " + namesOf(cameras) + "; info_camera should name one of them");
}

/// Where the camera is in the reference's optical frame.
Pose placeOf(const ListedCamera& camera, const std::vector<ListedCamera>& cameras,
             const std::string& reference) {
  const ListedCamera& other = find(cameras, reference, "info_reference");
  if (camera.X_BC && other.X_BC) return Pose(other.X_BC->inverse() * *camera.X_BC);
  throw Error("info_reference: the file does not say where " + camera.name + " is, seen from " +
              other.name + " (in a Kalibr camchain, T_cn_cnm1 does)");
}

}  // namespace

CalibratedCamera parseCalibration(const std::string& text, const std::string& file,
                                  const CalibrationChoice& choice, const CalibrationUse& use) {
  const std::vector<ListedCamera> cameras = listedCameras(text, file);
  const ListedCamera& chosen =
      base::namingPlace(file, [&]() -> const ListedCamera& { return chosenFrom(cameras, choice); });
  const std::string origin = file + (chosen.name.empty() ? "" : ": " + chosen.name);
  CalibratedCamera camera = cameraOf(Value(chosen.info), origin, use);
  if (choice.reference) {
    camera.X_FC = base::namingPlace(
        file, [&] { return Pose(placeOf(chosen, cameras, *choice.reference) * camera.X_FC); });
  }
  return camera;
}

CalibratedCamera readCalibration(const std::string& file, const CalibrationChoice& choice,
                                 const CalibrationUse& use) {
  return parseCalibration(base::readInput(file), file, choice, use);
}

}  // namespace synthetic_dataset::scene

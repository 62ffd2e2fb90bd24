#include <algorithm>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/label_writer.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset {
inline namespace v2 {

ObjectModel DatasetInfo::model(std::size_t object) const {
  if (!models_) throw Error("the dataset knows no models");
  return models_(object);
}

std::vector<std::string> DatasetInfo::splitFolders() const {
  std::vector<std::string> names;
  for (const SplitInfo& split : splits) names.push_back(split.name);
  if (names.empty()) names.emplace_back("train");
  return names;
}

std::size_t DatasetInfo::classIndex(int class_id) const {
  const auto found = std::find_if(classes.begin(), classes.end(),
                                  [&](const ClassInfo& each) { return each.id == class_id; });
  if (found == classes.end()) throw Error("no class has the number " + std::to_string(class_id));
  return static_cast<std::size_t>(found - classes.begin());
}

std::vector<std::string> DatasetInfo::classNamesWithoutGaps() const {
  std::vector<std::string> names;
  for (const ClassInfo& each : classes) {
    while (names.size() < static_cast<std::size_t>(each.id)) {
      names.push_back("unused_" + std::to_string(names.size()));
    }
    names.push_back(each.name);
  }
  return names;
}

std::optional<std::size_t> DatasetInfo::lidarIndex(Parameters& parameters, const std::string& name,
                                                   const std::string& lidar) const {
  std::vector<std::string> names;
  std::string listed;
  for (std::size_t i = 0; i < lidars.size(); ++i) {
    if (lidars[i].name == lidar) return i;
    names.push_back(lidars[i].name);
    listed += (listed.empty() ? "" : ", ") + lidars[i].name;
  }
  const std::string there = names.empty() ? "of which there is none" : listed;
  parameters.addError(name, "found '" + lidar + "'; it should be one of the run's lidars (" +
                                there + ")" + didYouMean(lidar, names));
  return std::nullopt;
}

std::string DatasetInfo::cameraFolder(std::size_t camera) const {
  return cameras.size() < 2 ? "" : safeFileName(cameras.at(camera).name) + "/";
}

void DatasetInfo::refuseVaryingIntrinsics(const std::string& file) const {
  for (const CameraDescription& camera : cameras) {
    if (!camera.intrinsics_vary) continue;
    throw Error("found a camera, '" + camera.name +
                "', whose intrinsics differ from scene to scene, and the format has one " + file +
                " for all of its images; they should be the same: without "
                "randomize/sensor/field_of_view, and with the same calibration in all motions. "
                "BOP, DOPE, KITTI and others hold each image's own");
  }
}

void DatasetInfo::refuseVaryingModels(const std::string& file) const {
  for (const ObjectInfo& object : objects) {
    if (!object.model_varies) continue;
    throw Error("found an object, '" + object.name +
                "', whose model, size or shape differs from scene to scene, and the format has "
                "one " +
                file +
                " of it for all images; it should be the same: without model, scale and variety: "
                "same_class in randomize, and with the same model in all motions. COCO, YOLO, "
                "KITTI and others hold what is seen in each image");
  }
}

}  // namespace v2
}  // namespace synthetic_dataset

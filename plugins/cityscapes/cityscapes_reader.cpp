#include <map>
#include <set>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "plugins/cityscapes/cityscapes_options.h"
#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "plugins/readback/json_file.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::cityscapes {
namespace {

/// Names by label (classes may share one), if the table exists: it is written when a dataset is
/// complete.
std::map<int, std::vector<std::string>> namesIn(const std::filesystem::path& file) {
  std::map<int, std::vector<std::string>> names;
  if (!std::filesystem::exists(file)) return names;
  readJson(file, [&](const nlohmann::json& table) {
    for (const auto& entry : table) {
      names[integerOf(entry.at("id"))].push_back(entry.at("name").get<std::string>());
    }
  });
  return names;
}

// Cityscapes: a picture of instances, label * 1000 + number; smaller numbers are labels without an
// instance.
LabelledPicture readScene(const WrittenScene& scene) {
  LabelledPicture picture{readPicture(scene.file("_leftImg8bit.png"), cv::IMREAD_COLOR), {}};
  const cv::Mat instances =
      readPicture(scene.file("_gtFine_instanceIds.png"), cv::IMREAD_UNCHANGED);
  if (instances.type() != CV_16UC1) {
    throw Error("'" + scene.file("_gtFine_instanceIds.png").string() +
                "': it should have one channel of 16 bits");
  }
  const auto names = namesIn(scene.folder / "labels.json");
  const cv::Mat_<ushort> pixels = instances;
  for (const int instance : std::set<int>(pixels.begin(), pixels.end())) {
    if (instance < kCityscapesInstances) continue;
    DrawnLabel label;
    const auto name = names.find(instance / kCityscapesInstances);
    if (name != names.end()) label.class_names = name->second;
    label.caption =
        (name == names.end() ? "" : name->second.front() + " ") + std::to_string(instance);
    label.mask = instances == instance;
    picture.labels.push_back(std::move(label));
  }
  return picture;
}

}  // namespace

Format format() { return {"synthetic_dataset/Cityscapes", true, readScene}; }

}  // namespace synthetic_dataset::formats::cityscapes

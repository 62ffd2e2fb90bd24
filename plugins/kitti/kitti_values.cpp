#include "plugins/kitti/kitti_values.h"

#include <map>

#include "plugins/kitti/kitti_options.h"
#include "plugins/kitti/kitti_scan.h"
#include "plugins/kitti/kitti_truth.h"

namespace synthetic_dataset::formats::kitti {
namespace {

class KittiValues : public ValueCheck {
 public:
  KittiValues(KittiOptions options, const DatasetInfo& dataset)
      : options_(std::move(options)), dataset_(dataset) {
    for (std::size_t camera = 0; camera < dataset_.cameras.size(); ++camera) {
      const std::string lists = dataset_.cameraFolder(camera) + "ImageSets/";
      for (const std::string& split : dataset_.splitFolders()) lists_[lists + split + ".txt"];
      lists_[lists + "trainval.txt"];
    }
  }

  void checkScene(const TrueScene& truth, FoundFiles& files) override {
    const Scene& scene = truth.scene;
    const std::string folder = dataset_.cameraFolder(scene.camera_index);
    std::string number = std::to_string(scene.instant);
    number.insert(0, number.size() < 6 ? 6 - number.size() : 0, '0');
    std::string lines;
    for (const SceneObject& object : scene.objects) lines += lineOf(object, scene.camera);
    files.compareWithScene(folder + "training/image_2/" + number + ".png", truth);
    compareKittiLabels(folder + "training/label_2/" + number + ".txt", lines, files);
    files.compareText(folder + "training/calib/" + number + ".txt",
                      trueKittiCalibration(scene.camera.intrinsics()));
    if (options_.velodyne) {
      compareScan(folder + "training/velodyne/" + number + ".bin", truth, files);
    }
    if (lines.empty()) return;  // OpenPCDet takes no image without a line
    const std::string split = scene.splitFolder();
    lists_[folder + "ImageSets/" + split + ".txt"] += number + "\n";
    if (split != "test") lists_[folder + "ImageSets/trainval.txt"] += number + "\n";
  }

  void checkDataset(FoundFiles& files) override {
    for (const auto& [name, lines] : lists_) files.compareText(name, lines);
  }

 private:
  [[nodiscard]] std::string lineOf(const SceneObject& object, const CameraModel& camera) const {
    const auto line = trueKittiLine(object, camera, options_);
    if (!line) return "";
    if (line->isDontCare()) {
      return line->type + " -1 -1 -10" + line->box + " -1 -1 -1 -1000 -1000 -1000 -10\n";
    }
    return line->type + kittiWords({object.truncation()}) + " " + std::to_string(line->occlusion) +
           kittiWords({line->alpha}) + line->box + line->columns + "\n";
  }

  KittiOptions options_;
  DatasetInfo dataset_;
  std::map<std::string, std::string> lists_;  ///< of images, by file
};

}  // namespace

std::unique_ptr<ValueCheck> valueCheck(Parameters& parameters, const DatasetInfo& dataset) {
  return std::make_unique<KittiValues>(readKittiOptions(parameters, dataset.classes), dataset);
}

}  // namespace synthetic_dataset::formats::kitti

#include "plugins/kitti_tracking/kitti_tracking_values.h"

#include <map>
#include <utility>

#include "plugins/kitti/kitti_truth.h"
#include "plugins/readback/sequence_values.h"

namespace synthetic_dataset::formats::kitti_tracking {
namespace {

class KittiTrackingValues : public ValueCheck {
 public:
  KittiTrackingValues(KittiOptions options, const DatasetInfo& dataset)
      : options_(std::move(options)),
        cameras_(dataset.cameras),
        splits_(dataset.splitFolders()),
        sequences_(dataset) {}

  void checkScene(const TrueScene& truth, FoundFiles& files) override {
    TrueSequence& sequence = sequences_.of(truth.scene);
    const std::string frame = std::to_string(sequence.images.size());
    sequences_.addFrame(truth, "png", sequence, files);
    for (const SceneObject& object : truth.scene.objects) {
      const std::string line = lineOf(object, truth.scene.camera);
      if (!line.empty()) sequence.labels += frame + " " + line;
    }
  }

  void checkDataset(FoundFiles& files) override {
    std::string frames;
    std::map<std::string, std::string> maps;  // by split: its sequences and their lengths
    for (const std::string& split : splits_) maps[split];
    std::int64_t index = 0;
    for (const TrueSequence& each : sequences_.all()) {
      const std::string name = withZeros(index++, 4);
      std::int64_t frame = 0;
      for (const std::string& image : each.images) {
        frames += name + " " + std::to_string(frame++) + " " + image + "\n";
      }
      if (each.images.empty()) continue;
      compareFrames(each, "training/image_02/" + name + "/", 0, "png", files);
      compareKittiLabels("training/label_02/" + name + ".txt", each.labels, files);
      files.compareText("training/calib/" + name + ".txt",
                        trueKittiCalibration(cameras_.at(each.camera).model.intrinsics()));
      maps[each.split] += name + " empty 000000 " + withZeros(frame, 6) + "\n";
    }
    files.compareText("frames.txt", frames);
    for (const auto& [split, lines] : maps) {
      files.compareText("evaluate_tracking.seqmap." + split, lines);
    }
  }

 private:
  /// The devkit's readme.txt: the track, the type, truncation as a whole number, and on as in the
  /// benchmark of objects.
  [[nodiscard]] std::string lineOf(const SceneObject& object, const CameraModel& camera) const {
    const auto line = trueKittiLine(object, camera, options_);
    if (!line) return "";
    if (line->isDontCare()) {
      return "-1 " + line->type + " -1 -1 -10" + line->box + " -1000 -1000 -1000 -10 -1 -1 -1\n";
    }
    return std::to_string(object.instance - 1) + " " + line->type + " " +
           truncationOf(object.truncation()) + " " + std::to_string(line->occlusion) +
           kittiWords({line->alpha}) + line->box + line->columns + "\n";
  }

  /// 0 where it is in the image but for a hundredth, 2 where more than half is outside.
  static std::string truncationOf(double share) {
    return share < 0.01 ? "0" : share > 0.5 ? "2" : "1";
  }

  KittiOptions options_;
  std::vector<CameraDescription> cameras_;
  std::vector<std::string> splits_;
  TrueSequences sequences_;
};

}  // namespace

std::unique_ptr<ValueCheck> valueCheck(Parameters& parameters, const DatasetInfo& dataset) {
  return std::make_unique<KittiTrackingValues>(readKittiOptions(parameters, dataset.classes),
                                               dataset);
}

}  // namespace synthetic_dataset::formats::kitti_tracking

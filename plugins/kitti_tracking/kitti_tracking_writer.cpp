#include <array>
#include <cstdio>
#include <ostream>
#include <string>

#include <pluginlib/class_list_macros.hpp>

#include "plugins/kitti/kitti_options.h"
#include "plugins/shared/kitti_columns.h"
#include "plugins/shared/pose_formats.h"
#include "plugins/shared/sequences.h"
#include "synthetic_dataset/box_choice.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {
namespace {

std::string fourDigits(std::size_t number) {
  std::array<char, 24> digits{};
  std::snprintf(digits.data(), digits.size(), "%04zu", number);
  return digits.data();
}

/// Tracking has whole numbers where the object benchmark has shares: 0 not, 1 partly, 2 largely out
/// of the image.
int truncationOf(double share) {
  constexpr double kNone = 0.01;
  if (share < kNone) return 0;
  return share <= 0.5 ? 1 : 2;
}

}  // namespace

/// KITTI's tracking benchmark: `training/{image_02/SSSS/NNNNNN.png, label_02/SSSS.txt,
/// calib/SSSS.txt}`, `evaluate_tracking.seqmap.<split>`. Frames and tracks count from 0.
/// http://www.cvlibs.net/datasets/kitti/eval_tracking.php, readme.txt of its devkit_tracking
class KittiTrackingWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset) override {
    dataset.refuseVaryingIntrinsics("training/calib/");
    options_ = readKittiOptions(parameters, dataset.classes);
    if (options_.velodyne) {
      parameters.addError("velodyne", "found 'depth'; only synthetic_dataset/Kitti writes points");
    }
    sequences_ = Sequences(dataset);
    cameras_ = dataset.cameras;
    splits_ = dataset.splitFolders();
  }

  [[nodiscard]] Requirements doRequirements() const override {
    Requirements requirements;
    requirements.visible_masks = true;
    requirements.visibility = true;
    return requirements;
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    warnOfDistortion(scene.camera, output);
    std::string labels;
    bool is_tilted = false;
    for (const SceneObject& object : scene.objects) {
      if (object.labelled()) {
        labels += label(object, scene.camera);
        is_tilted = is_tilted || kitti::isTilted(*object.X_CO);
      } else if (options_.dont_care && object.pixels.visible() > 0) {
        labels += dontCare(object, scene.camera);
      }
    }
    if (is_tilted) output.addWarning(kitti::kTiltWarning);
    sequences_.addFrame(scene, "png", labels, output);
  }

  /// An object's line without the frame; nothing for one without box in the image.
  [[nodiscard]] std::string label(const SceneObject& object, const CameraModel& camera) const {
    const auto box = boxOf(object, options_.box, camera);
    if (!box) return "";
    const kitti::Placement placement = kitti::placementOf(object);
    return std::to_string(object.instance - 1) + " " + options_.types.at(object.class_name) + " " +
           std::to_string(truncationOf(object.truncation())) + " " +
           std::to_string(kitti::occlusionOf(object.pixels)) + kitti::columns({placement.alpha}) +
           kitti::boxColumns(*box) + placement.columns + "\n";
  }

  [[nodiscard]] static std::string dontCare(const SceneObject& object, const CameraModel& camera) {
    const auto box = boxOf(object, BoxChoice::kVisible, camera);
    if (!box) return "";
    return std::string("-1 ") + kDontCare + " -1 -1 -10" + kitti::boxColumns(*box) +
           " -1000 -1000 -1000 -10 -1 -1 -1\n";
  }

  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    for (std::size_t i = 0; i < sequences_.all().size(); ++i) addSequence(i, records, output);
    output.addFile(kFrameList, [&](std::ostream& list) {
      for (std::size_t i = 0; i < sequences_.all().size(); ++i) {
        sequences_.forEachFrame(
            i, records,
            [&](std::int64_t frame, const std::string& image, const std::string& /*labels*/) {
              list << fourDigits(i) << ' ' << frame << ' ' << image << '\n';
            });
      }
    });
    for (const std::string& split : splits_) addSequenceMap(split, records, output);
  }

  void addSequence(std::size_t sequence, const SceneRecords& records, DatasetOutput& output) const {
    const std::string name = fourDigits(sequence);
    if (lengthOf(sequence, records) == 0) return;
    sequences_.forEachFrame(
        sequence, records,
        [&](std::int64_t frame, const std::string& image, const std::string& /*labels*/) {
          output.addLink("training/image_02/" + name + "/" + sixDigits(frame) + ".png", image);
        });
    output.addFile("training/label_02/" + name + ".txt", [&](std::ostream& file) {
      sequences_.forEachFrame(
          sequence, records,
          [&](std::int64_t frame, const std::string& /*image*/, const std::string& labels) {
            file << withFrame(frame, ' ', labels);
          });
    });
    output.addFile("training/calib/" + name + ".txt", [&](std::ostream& file) {
      const std::size_t camera = sequences_.all()[sequence].camera;
      file << kitti::calibration(cameras_.at(camera).model.intrinsics());
    });
  }

  /// The sequences of a split and their numbers of frames, as the devkit reads them.
  void addSequenceMap(const std::string& split, const SceneRecords& records,
                      DatasetOutput& output) const {
    output.addFile("evaluate_tracking.seqmap." + split, [&](std::ostream& file) {
      for (std::size_t i = 0; i < sequences_.all().size(); ++i) {
        const std::int64_t length = lengthOf(i, records);
        if (sequences_.all()[i].split != split || length == 0) continue;
        file << fourDigits(i) << " empty " << sixDigits(0) << ' ' << sixDigits(length) << '\n';
      }
    });
  }

  [[nodiscard]] std::int64_t lengthOf(std::size_t sequence, const SceneRecords& records) const {
    std::int64_t length = 0;
    sequences_.forEachFrame(sequence, records,
                            [&](std::int64_t /*frame*/, const std::string& /*image*/,
                                const std::string& /*labels*/) { ++length; });
    return length;
  }

  KittiOptions options_;
  Sequences sequences_;
  std::vector<CameraDescription> cameras_;
  std::vector<std::string> splits_;
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::KittiTrackingWriter, synthetic_dataset::LabelWriter)

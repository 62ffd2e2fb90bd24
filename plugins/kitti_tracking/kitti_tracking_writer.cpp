#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <ostream>
#include <set>
#include <string>

#include <pluginlib/class_list_macros.hpp>

#include "plugins/kitti/kitti_labels.h"
#include "plugins/shared/pose_formats.h"
#include "plugins/shared/sequences.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {
namespace {

std::string fourDigits(std::size_t number) {
  std::array<char, 24> digits{};
  std::snprintf(digits.data(), digits.size(), "%04zu", number);
  return digits.data();
}

}  // namespace

/// KITTI's tracking benchmark: `training/{image_02/SSSS/NNNNNN.png, label_02/SSSS.txt,
/// calib/SSSS.txt}`, `evaluate_tracking.seqmap.<split>`. Frames and tracks count from 0.
/// http://www.cvlibs.net/datasets/kitti/eval_tracking.php, readme.txt of its devkit_tracking
class KittiTrackingWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset) override {
    dataset.refuseVaryingIntrinsics("training/calib/");
    options_ = readKittiOptions(parameters, dataset);
    if (options_.velodyne) {
      parameters.addError("velodyne",
                          "found 'depth', from which only synthetic_dataset/Kitti makes points; it "
                          "should be none or a lidar's name");
    }
    warnOfUnknownTypes(parameters);
    sequences_ = Sequences(dataset);
    cameras_ = dataset.cameras;
    splits_ = dataset.splitFolders();
  }

  /// TrackEval rejects labels of unknown types (trackeval/datasets/kitti_2d_box.py).
  void warnOfUnknownTypes(WriterParameters& parameters) const {
    static const std::set<std::string> kKnown = {"car",     "van",  "truck", "pedestrian", "person",
                                                 "cyclist", "tram", "misc",  "dontcare"};
    for (const auto& [name, type] : options_.types) {
      std::string small = type;
      std::transform(small.begin(), small.end(), small.begin(),
                     [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      if (kKnown.count(small) != 0) continue;
      parameters.addWarning("TrackEval does not know the type '" + type +
                            "', and refuses such labels; `class_names: {\"" + name +
                            "\": Car}` or Pedestrian, which it evaluates, writes another one");
    }
  }

  [[nodiscard]] Requirements doRequirements() const override {
    return kitti::requirementsOf(options_);
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    warnOfDistortion(scene.camera, output);
    sequences_.addFrame(
        scene, "png", kitti::labels(scene, options_, kitti::Benchmark::kTracking, output), output);
    if (!options_.lidar) return;
    output.addText(scanOf("scenes/" + scene.name + ".png"), kitti::lidarPoints(scene, options_));
    output.addRecord(
        scannerChannel(scene.camera_index),
        kitti::calibration(scene.camera.intrinsics(), kitti::lidarInCamera(scene, options_)));
  }

  /// The file of points that belongs to a scene's image.
  [[nodiscard]] static std::string scanOf(const std::string& image) {
    return image.substr(0, image.rfind('.')) + ".bin";
  }

  [[nodiscard]] static std::string scannerChannel(std::size_t camera) {
    return "calib " + std::to_string(camera);
  }

  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    std::vector<std::string> folders;
    for (std::size_t i = 0; i < sequences_.all().size(); ++i) {
      folders.push_back(fourDigits(i));
      addSequence(i, folders.back(), records, output);
    }
    sequences_.addFrameList(folders, records, output);
    for (const std::string& split : splits_) addSequenceMap(split, records, output);
  }

  void addSequence(std::size_t sequence, const std::string& name, const SceneRecords& records,
                   DatasetOutput& output) const {
    if (sequences_.length(sequence, records) == 0) return;
    sequences_.forEachFrame(
        sequence, records,
        [&](std::int64_t frame, const std::string& image, const std::string& /*labels*/) {
          output.addLink("training/image_02/" + name + "/" + sixDigits(frame) + ".png", image);
          if (!options_.lidar) return;
          output.addLink("training/velodyne/" + name + "/" + sixDigits(frame) + ".bin",
                         scanOf(image));
        });
    sequences_.addLabels("training/label_02/" + name + ".txt", sequence, ' ', records, output);
    output.addText("training/calib/" + name + ".txt",
                   calibrationOf(sequences_.all()[sequence].camera, records));
  }

  /// The calibration of a camera's first scene; the scanner is assumed not to move relative to the
  /// camera.
  [[nodiscard]] std::string calibrationOf(std::size_t camera, const SceneRecords& records) const {
    std::string first;
    if (options_.lidar) {
      records.forEach(scannerChannel(camera), [&](std::int64_t, const std::string& record) {
        if (first.empty()) first = record;
      });
    }
    if (!first.empty()) return first;
    return kitti::calibration(cameras_.at(camera).model.intrinsics(), kitti::scannerInCamera());
  }

  /// Writes the sequences of a split and their numbers of frames in the devkit's form.
  void addSequenceMap(const std::string& split, const SceneRecords& records,
                      DatasetOutput& output) const {
    output.addFile("evaluate_tracking.seqmap." + split, [&](std::ostream& file) {
      for (std::size_t i = 0; i < sequences_.all().size(); ++i) {
        const std::int64_t length = sequences_.length(i, records);
        if (sequences_.all()[i].split != split || length == 0) continue;
        file << fourDigits(i) << " empty " << sixDigits(0) << ' ' << sixDigits(length) << '\n';
      }
    });
  }

  KittiOptions options_;
  Sequences sequences_;
  std::vector<CameraDescription> cameras_;
  std::vector<std::string> splits_;
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::KittiTrackingWriter, synthetic_dataset::LabelWriter)

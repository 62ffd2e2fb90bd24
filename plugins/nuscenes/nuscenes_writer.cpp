#include <ostream>
#include <string>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <pluginlib/class_list_macros.hpp>

#include "plugins/nuscenes/nuscenes_frames.h"
#include "plugins/nuscenes/nuscenes_options.h"
#include "plugins/nuscenes/nuscenes_scenes.h"
#include "plugins/nuscenes/nuscenes_tables.h"
#include "plugins/shared/json.h"
#include "plugins/shared/pose_formats.h"
#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// nuScenes: `samples/CAM_*/` with images, and tables of JSON that refer to one another by tokens.
/// https://www.nuscenes.org/nuscenes#data-format, https://github.com/nutonomy/nuscenes-devkit
/// (docs/schema_nuscenes.md)
class NuScenesWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset) override {
    dataset.refuseVaryingIntrinsics("calibrated_sensor.json");
    options_ = readNuScenesOptions(parameters);
    if (const auto problem = nuscenes::sceneNameProblem(dataset)) parameters.addError("", *problem);
    dataset_ = dataset;
  }

  [[nodiscard]] Requirements doRequirements() const override {
    Requirements requirements = requirementsOf(options_.box);
    requirements.visibility = true;
    return requirements;
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    warnOfDistortion(scene.camera, output);
    nuscenes::Frame frame;
    frame.instant = scene.instant;
    frame.microseconds = scene.stamp.count() / 1000;
    frame.sequence = static_cast<std::int64_t>(nuScenesSequence(dataset_, scene));
    frame.camera = static_cast<std::int64_t>(scene.camera_index);
    frame.file = "samples/" + nuScenesChannel(dataset_.cameras, scene.camera_index) + "/" +
                 scene.flatName() + "." + options_.image_format;
    frame.X_GE = nuscenes::placementOf(scene.X_GC * bodyInCamera());
    for (const SceneObject& object : scene.objects) {
      const auto box = boxOf(object, options_.box, scene.camera);
      if (object.labelled() && box) frame.objects.push_back(seenObject(object, *box));
    }
    output.addImage(frame.file, scene.image);
    output.addRecord(kFrames, nuscenes::recordOf(frame));
  }

  /// A frame with x ahead, y left and z up in the optical frame.
  [[nodiscard]] static Pose bodyInCamera() {
    Eigen::Matrix3d rotation;
    rotation << 0.0, -1.0, 0.0,  //
        0.0, 0.0, -1.0,          //
        1.0, 0.0, 0.0;
    return makePose(Eigen::Vector3d::Zero(), Eigen::Quaterniond(rotation));
  }

  [[nodiscard]] static nuscenes::SeenObject seenObject(const SceneObject& object, const Box& box) {
    const Eigen::Vector3d size = object.cuboid_O.size();
    Pose X_GB = *object.X_GO;
    X_GB.translation() = *object.X_GO * object.cuboid_O.centre();
    return {object.instance - 1,
            nuscenes::placementOf(X_GB),
            {size.y(), size.x(), size.z()},
            object.visibility(),
            object.pixels.visible(),
            {box.left + 0.5, box.top + 0.5, box.right + 0.5, box.bottom + 0.5}};
  }

  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    std::vector<nuscenes::Frame> frames;
    records.forEach(kFrames, [&](std::int64_t scene, const std::string& record) {
      frames.push_back(nuscenes::frameOf(scene, record));
    });
    for (const nuscenes::Table& table :
         nuscenes::tablesOf(dataset_, frames, options_.image_format)) {
      output.addFile(options_.version + "/" + table.name + ".json", [&](std::ostream& file) {
        const char* separator = "\n";
        file << '[';
        table.make([&](const Json& record) {
          file << separator << jsonText(record);
          separator = ",\n";
        });
        file << "]\n";
      });
    }
    output.addFile(kNuScenesMap, [](std::ostream& file) {
      std::vector<uchar> bytes;
      cv::imencode(".png", cv::Mat(1, 1, CV_8UC1, cv::Scalar(0)), bytes);
      for (const uchar each : bytes) file.put(static_cast<char>(each));
    });
  }

  static constexpr const char* kFrames = "frames";  // of records: all

  NuScenesOptions options_;
  DatasetInfo dataset_;
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::NuScenesWriter, synthetic_dataset::LabelWriter)

#include <cstdint>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include <pluginlib/class_list_macros.hpp>

#include "plugins/pvnet/pvnet_model.h"
#include "plugins/pvnet/pvnet_pose.h"
#include "plugins/shared/json.h"
#include "plugins/shared/plain_file_name.h"
#include "plugins/shared/pose_formats.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {
namespace {

/// A pose's 3 x 4 matrix [R | t].
Json rowsOf(const Pose& pose) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i) {
    const auto row = pose.matrix().row(i);
    rows.push_back({row(0), row(1), row(2), row(3)});
  }
  return rows;
}

/// A line of numbers for numpy.loadtxt, each the shortest text that gives the same double.
std::string lineOf(const std::vector<double>& numbers) {
  std::string line;
  for (const double number : numbers) line += (line.empty() ? "" : " ") + Json(number).dump();
  return line + "\n";
}

std::string linesOf(const std::vector<Eigen::Vector3d>& points) {
  std::string lines;
  for (const Eigen::Vector3d& point : points) lines += lineOf({point.x(), point.y(), point.z()});
  return lines;
}

std::string linesOf(const Intrinsics& k) {
  return lineOf({k.fx, 0.0, k.cx}) + lineOf({0.0, k.fy, k.cy}) + lineOf({0.0, 0.0, 1.0});
}

/// What is kept of a scene until the end: the objects for which it is a sample.
struct SceneRecord {
  std::size_t camera = 0;
  std::int64_t instant = 0;
  std::string split;
  std::string samples;  ///< a character for each object: whether it has one, '0' or '1'

  [[nodiscard]] std::string text() const {
    return std::to_string(camera) + " " + std::to_string(instant) + " " + split + " " + samples;
  }

  [[nodiscard]] static SceneRecord of(const std::string& text) {
    SceneRecord record;
    std::istringstream stream(text);
    stream.imbue(std::locale::classic());
    stream >> record.camera >> record.instant >> record.split >> record.samples;
    return record;
  }
};

}  // namespace

/// PVNet's custom datasets: for each object a folder with `rgb/i.jpg`, `mask/i.png`,
/// `pose/posei.npy`, its model and `train.json`, i from 0 without gaps; in metres.
/// https://github.com/zju3dv/clean-pvnet#training-on-the-custom-object, and the files that its
/// tools/handle_custom_dataset.py makes from such a folder.
class PvNetWriter : public LabelWriter {
 private:
  /// The folder of an object, or of an object and a camera.
  struct Folder {
    std::size_t object = 0;
    std::size_t camera = 0;
    std::string path;  ///< with a `/` at its end
  };

  void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset) override {
    dataset.refuseVaryingIntrinsics("camera.txt");
    dataset.refuseVaryingModels("model.ply");
    dataset_ = dataset;
    image_format_ = "." + parameters.optionalChoice("image_format", {"jpg", "png"}, "jpg");
    data_root_ = parameters.optional<std::string>("data_root", "data/custom");
    for (std::size_t i = 0; i < dataset.objects.size(); ++i) {
      models_.push_back(PvNetModel::of(dataset.model(i)));
    }
  }

  [[nodiscard]] Requirements doRequirements() const override {
    Requirements requirements;
    requirements.visible_masks = true;
    return requirements;
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    warnOfDistortion(scene.camera, output);
    SceneRecord record{scene.camera_index, scene.instant, scene.splitFolder(), ""};
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      const SceneObject& object = scene.objects[i];
      const bool is_sample = object.labelled() && models_.at(i) &&
                             models_.at(i)->projectsOntoImagePlane(scene.camera, *object.X_CO);
      record.samples += is_sample ? '1' : '0';
      if (is_sample) {
        addSample(object, scene, folderOf(i, scene.camera_index).path + "scenes/", output);
      } else if (object.labelled()) {
        output.addWarning(object.name +
                          ": part of it is behind the camera; samples like this are left out");
      }
    }
    output.addRecord(kSamples, record.text());
  }

  void addSample(const SceneObject& object, const Scene& scene, const std::string& scenes,
                 SceneOutput& output) const {
    const std::string number = sceneNumber(scene.instant);
    output.addImage(scenes + "rgb/" + number + image_format_, scene.image);
    output.addMask(scenes + "mask/" + number + ".png", object.visible_mask());
    output.addText(scenes + "pose/" + number + ".npy", numpyPose(*object.X_CO));
  }

  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    for (std::size_t object = 0; object < models_.size(); ++object) {
      if (!models_[object]) continue;
      const ObjectModel surface = dataset_.model(object);
      for (std::size_t camera = 0; camera < dataset_.cameras.size(); ++camera) {
        const Folder folder = folderOf(object, camera);
        addNumberedFiles(records, folder, output);
        addModelFiles(folder, surface, output);
        for (const std::string& split : dataset_.splitFolders()) {
          addSplit(records, folder, split, output);
        }
      }
    }
  }

  [[nodiscard]] Folder folderOf(std::size_t object, std::size_t camera) const {
    return {object, camera,
            plainFileName(dataset_.objects.at(object).name) + "/" + dataset_.cameraFolder(camera)};
  }

  /// @param visit  is called with each sample of a folder: its number from 0, the scene's name in
  ///     the folder `scenes`, and its split
  template <class Visit>
  static void forEachSample(const SceneRecords& records, const Folder& folder, const Visit& visit) {
    std::int64_t count = 0;
    records.forEach(kSamples, [&](std::int64_t /*scene*/, const std::string& text) {
      const SceneRecord record = SceneRecord::of(text);
      if (record.camera != folder.camera || record.samples.at(folder.object) != '1') return;
      visit(std::to_string(count++), sceneNumber(record.instant), record.split);
    });
  }

  /// Adds the files under numbers without gaps, which are only known at the end.
  void addNumberedFiles(const SceneRecords& records, const Folder& folder,
                        DatasetOutput& output) const {
    const std::string scenes = folder.path + "scenes/";
    forEachSample(
        records, folder, [&](const std::string& i, const std::string& scene, const std::string&) {
          output.addLink(folder.path + "rgb/" + i + image_format_,
                         scenes + "rgb/" + scene + image_format_);
          output.addLink(folder.path + "mask/" + i + ".png", scenes + "mask/" + scene + ".png");
          output.addLink(folder.path + "pose/pose" + i + ".npy", scenes + "pose/" + scene + ".npy");
        });
  }

  void addModelFiles(const Folder& folder, const ObjectModel& surface,
                     DatasetOutput& output) const {
    const PvNetModel& model = *models_[folder.object];
    output.addFile(folder.path + "model.ply",
                   [&](std::ostream& stream) { writePly(stream, surface, 1.0); });
    const CameraModel& camera = dataset_.cameras[folder.camera].model;
    output.addText(folder.path + "camera.txt", linesOf(camera.intrinsics()));
    output.addText(folder.path + "diameter.txt", lineOf({model.diameter}));
    output.addText(folder.path + "fps.txt", linesOf(model.farthest_points));
    output.addText(folder.path + "corners.txt", linesOf(model.corners));
  }

  /// Writes `train.json` or the file of another split: images, then annotations, both numbered from
  /// 1.
  void addSplit(const SceneRecords& records, const Folder& folder, const std::string& split,
                DatasetOutput& output) const {
    const auto addList = [&](std::ostream& stream, const auto& entryOf) {
      int id = 0;
      forEachSample(records, folder,
                    [&](const std::string& i, const std::string& scene, const std::string& of) {
                      if (of != split) return;
                      ++id;
                      stream << (id == 1 ? "\n" : ",\n") << jsonText(entryOf(id, i, scene));
                    });
    };
    output.addFile(folder.path + split + ".json", [&](std::ostream& stream) {
      stream << "{\"images\": [";
      addList(stream, [&](int id, const std::string& i, const std::string&) {
        return imageEntry(folder, id, i);
      });
      stream << "],\n\"annotations\": [";
      addList(stream, [&](int id, const std::string& i, const std::string& scene) {
        const std::string file = folder.path + "scenes/pose/" + scene + ".npy";
        return annotation(folder, id, i, poseOfNumpy(output.readFile(file)));
      });
      stream << "],\n\"categories\": "
             << Json::array({{{"supercategory", "none"}, {"id", 1}, {"name", kClass}}}).dump()
             << "}\n";
    });
  }

  [[nodiscard]] Json imageEntry(const Folder& folder, int id, const std::string& i) const {
    const CameraModel& camera = dataset_.cameras[folder.camera].model;
    return {{"file_name", data_root_ + "/rgb/" + i + image_format_},
            {"height", camera.height()},
            {"width", camera.width()},
            {"id", id}};
  }

  [[nodiscard]] Json annotation(const Folder& folder, int id, const std::string& i,
                                const Pose& X_CO) const {
    const CameraModel& camera = dataset_.cameras[folder.camera].model;
    Json entry = models_[folder.object]->annotation(camera, X_CO);
    const Intrinsics& k = camera.intrinsics();
    entry["mask_path"] = data_root_ + "/mask/" + i + ".png";
    entry["image_id"] = id;
    entry["category_id"] = 1;
    entry["id"] = id;
    entry["K"] = {{k.fx, 0.0, k.cx}, {0.0, k.fy, k.cy}, {0.0, 0.0, 1.0}};
    entry["pose"] = rowsOf(X_CO);
    entry["data_root"] = data_root_ + "/rgb";
    entry["type"] = "real";  // its masks are nonzero on the object
    entry["cls"] = kClass;
    return entry;
  }

  /// The loader looks this name up among LINEMOD's objects, but any of them will do; clean-pvnet
  /// writes this one.
  static constexpr const char* kClass = "cat";

  static constexpr const char* kSamples = "samples";  // channel of records

  DatasetInfo dataset_;
  std::vector<std::optional<PvNetModel>> models_;  ///< of each object
  std::string image_format_ = ".jpg";
  std::string data_root_;
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::PvNetWriter, synthetic_dataset::LabelWriter)

#include "plugins/cityscapes/cityscapes_values.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "plugins/cityscapes/cityscapes_options.h"
#include "plugins/readback/json_file.h"
#include "plugins/readback/json_text.h"
#include "plugins/readback/mask_shapes.h"
#include "plugins/readback/true_parts.h"

namespace synthetic_dataset::formats::cityscapes {
namespace {

using nlohmann::json;

/// What has a label in a picture: a class of the world, or an object.
struct Labelled {
  Mask mask;
  int label = 0;
  int instance = 0;   ///< in the picture of instances
  std::string name;   ///< in the polygons
  std::string whose;  ///< for messages
};

class CityscapesValues : public ValueCheck {
 public:
  CityscapesValues(CityscapesOptions options, const DatasetInfo& dataset)
      : options_(std::move(options)), cities_(cityNames(dataset.cameras)) {}

  void checkScene(const TrueScene& truth, FoundFiles& files) override {
    const Scene& scene = truth.scene;
    const std::string& city = cities_.at(scene.camera_index);
    std::string number = std::to_string(scene.instant);
    number.insert(0, number.size() < 6 ? 6 - number.size() : 0, '0');
    const std::string name =
        scene.splitFolder() + "/" + city + "/" + city + "_" + number + "_000019";
    const std::vector<Labelled> labelled = labelledOf(scene);
    files.compareWithScene("leftImg8bit/" + name + "_leftImg8bit.png", truth);
    files.compareWithScene("imgsFine/leftImg8bit/" + name + "_leftImg8bit.png", truth);
    comparePictures(scene, labelled, "gtFine/" + name + "_gtFine_", files);
    comparePolygons(scene, labelled, "gtFine/" + name + "_gtFine_polygons.json", files);
    compareCamera(scene, "camera/" + name + "_camera.json", files);
  }

  void checkDataset(FoundFiles& files) override {
    files.compareJson("labels.json", table());
    files.compareText("label_colors.txt", colourList());
  }

 private:
  [[nodiscard]] std::vector<Labelled> labelledOf(const Scene& scene) const {
    std::vector<Labelled> labelled;
    for (std::size_t i = 0; i < options_.world.size(); ++i) {
      const auto& [name, id, class_id] = options_.world[i];
      labelled.push_back({Mask(trueWorldClass(scene, i + 1)), id, id, name, "'" + name + "'"});
    }
    std::map<int, int> counts;  // by label
    for (const SceneObject& object : scene.objects) {
      const auto label =
          std::find_if(options_.labels.begin(), options_.labels.end(),
                       [&](const auto& each) { return each.class_id == object.class_id; });
      if (!object.labelled() || label == options_.labels.end()) continue;
      const int count = counts[label->id]++;
      const bool is_single = count < kCityscapesInstances;
      labelled.push_back({object.visible_mask(), label->id,
                          is_single ? label->id * kCityscapesInstances + count : label->id,
                          label->name + (is_single ? "" : "group"), "'" + object.name + "'"});
    }
    return labelled;
  }

  void comparePictures(const Scene& scene, const std::vector<Labelled>& labelled,
                       const std::string& beginning, FoundFiles& files) const {
    const cv::Size size(scene.camera.width(), scene.camera.height());
    cv::Mat labels(size, CV_8UC1, cv::Scalar(options_.world_id));
    cv::Mat instances(size, CV_16UC1, cv::Scalar(options_.world_id));
    for (const SceneObject& object : scene.objects) {  // 0, unlabeled, for those without a label
      labels.setTo(0, object.visible_mask().whole());
      instances.setTo(0, object.visible_mask().whole());
    }
    for (const Labelled& each : labelled) {
      labels.setTo(each.label, each.mask.whole());
      instances.setTo(each.instance, each.mask.whole());
    }
    cv::Mat train_ids(size, CV_8UC1, cv::Scalar(kCityscapesIgnored));
    cv::Mat picture(size, CV_8UC3, cv::Scalar::all(0));
    for (const CityscapesEntry& each : options_.table) {
      const cv::Mat pixels = labels == each.id;
      const auto& [red, green, blue] = each.colour;
      train_ids.setTo(each.train_id, pixels);
      picture.setTo(cv::Scalar(blue, green, red), pixels);
    }
    files.comparePicture(beginning + "labelTrainIds.png", train_ids);
    files.comparePicture(beginning + "labelIds.png", labels);
    files.comparePicture(beginning + "instanceIds.png", instances);
    files.comparePicture(beginning + "color.png", picture);
  }

  static void comparePolygons(const Scene& scene, const std::vector<Labelled>& labelled,
                              const std::string& name, FoundFiles& files) {
    const auto file = files.take(name);
    if (!file) return;
    readJson(*file, [&](json found) {
      json right = {{"imgHeight", scene.camera.height()},
                    {"imgWidth", scene.camera.width()},
                    {"objects", json::array()}};
      std::size_t i = 0;
      for (const Labelled& each : labelled) {
        if (each.mask.empty()) continue;
        right["objects"].push_back({{"label", asJsonHasIt(each.name)}});
        if (i >= found.at("objects").size()) continue;
        json& object = found["objects"][i++];
        const std::string problem = outlineProblem(object.at("polygon"), each.mask);
        if (!problem.empty()) files.differences().add(name + ", " + each.whose + ": " + problem);
        object.erase("polygon");
      }
      compareJson(found, right, name, files.differences());
    });
  }

  static void compareCamera(const Scene& scene, const std::string& name, FoundFiles& files) {
    const auto file = files.take(name);
    if (!file) return;
    readJson(*file, [&](const json& found) {
      compareJson(found, cameraOf(scene, found), name, files.differences());
    });
  }

  /// csCalibration.pdf: x ahead, y left, z up; roll, pitch and yaw about its x, y and z, so that
  /// the axes turn by Rz(yaw) Ry(pitch) Rx(roll). Several angles may stand for one rotation.
  /// @param found  whose angles are right where they are those of the rotation
  static json cameraOf(const Scene& scene, const json& found) {
    Eigen::Matrix3d R_GB;  // B: the camera with these axes
    const Eigen::Matrix3d R_GC = scene.X_GC.linear();
    R_GB << R_GC.col(2), -R_GC.col(0), -R_GC.col(1);
    const auto angleOf = [&](const char* angle) {
      return found.at("extrinsic").at(angle).get<double>();
    };
    const Eigen::Matrix3d R_found = (Eigen::AngleAxisd(angleOf("yaw"), Eigen::Vector3d::UnitZ()) *
                                     Eigen::AngleAxisd(angleOf("pitch"), Eigen::Vector3d::UnitY()) *
                                     Eigen::AngleAxisd(angleOf("roll"), Eigen::Vector3d::UnitX()))
                                        .toRotationMatrix();
    constexpr double kTolerance = 1e-6;
    const bool is_right = (R_found - R_GB).cwiseAbs().maxCoeff() <= kTolerance;
    const Eigen::Vector3d p = scene.X_GC.translation();
    const Intrinsics& k = scene.camera.intrinsics();
    json right = {{"extrinsic",
                   {{"x", p.x()},
                    {"y", p.y()},
                    {"z", p.z()},
                    {"roll", std::atan2(R_GB(2, 1), R_GB(2, 2))},
                    {"pitch", -std::asin(std::clamp(R_GB(2, 0), -1.0, 1.0))},
                    {"yaw", std::atan2(R_GB(1, 0), R_GB(0, 0))}}},
                  {"intrinsic", {{"fx", k.fx}, {"fy", k.fy}, {"u0", k.cx}, {"v0", k.cy}}}};
    for (const char* angle : {"roll", "pitch", "yaw"}) {
      if (is_right) right["extrinsic"][angle] = angleOf(angle);
    }
    return right;
  }

  [[nodiscard]] json table() const {
    json table = json::array();
    for (const CityscapesEntry& each : options_.table) {
      table.push_back({{"name", asJsonHasIt(each.name)},
                       {"id", each.id},
                       {"trainId", each.train_id},
                       {"category", each.category},
                       {"categoryId", each.category_id},
                       {"hasInstances", each.has_instances},
                       {"ignoreInEval", each.is_ignored},
                       {"color", each.colour}});
    }
    return table;
  }

  /// The labels that are trained, each once, by their train ids: colour and name in one word.
  [[nodiscard]] std::string colourList() const {
    std::map<int, const CityscapesEntry*> trained;
    for (const CityscapesEntry& each : options_.table) {
      if (each.train_id != kCityscapesIgnored) trained.emplace(each.train_id, &each);
    }
    std::string lines;
    std::set<std::string> taken = {"background"};
    for (const auto& [train_id, entry] : trained) {
      std::string name = entry->name;
      std::replace_if(
          name.begin(), name.end(), [](unsigned char c) { return c <= ' ' || c == 0x7F; }, '_');
      if (taken.count(name) != 0) name += "_" + std::to_string(train_id);
      taken.insert(name);
      for (const int channel : entry->colour) lines += std::to_string(channel) + " ";
      lines += name + "\n";
    }
    return lines + "0 0 0 background\n";
  }

  CityscapesOptions options_;
  std::vector<std::string> cities_;
};

}  // namespace

std::unique_ptr<ValueCheck> valueCheck(Parameters& parameters, const DatasetInfo& dataset) {
  return std::make_unique<CityscapesValues>(
      readCityscapesOptions(parameters, dataset.classes, dataset.world_classes), dataset);
}

}  // namespace synthetic_dataset::formats::cityscapes

#include "plugins/image_folder/image_folder_values.h"

#include <map>
#include <sstream>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "plugins/image_folder/image_folder_card.h"
#include "plugins/image_folder/image_folder_options.h"
#include "plugins/image_folder/line_index.h"
#include "plugins/readback/files.h"
#include "plugins/readback/json_file.h"
#include "plugins/readback/json_text.h"

namespace synthetic_dataset::formats::image_folder {
namespace {

using nlohmann::json;

json matrixOf(const Pose& pose) {
  json numbers = json::array();
  for (int i = 0; i < 16; ++i) numbers.push_back(pose.matrix()(i / 4, i % 4));
  return numbers;
}

class ImageFolderValues : public ValueCheck {
 public:
  ImageFolderValues(ImageFolderOptions options, const DatasetInfo& dataset)
      : options_(std::move(options)), dataset_(dataset) {
    for (const std::string& split : dataset_.splitFolders()) counts_[split] = 0;
  }

  void checkScene(const TrueScene& truth, FoundFiles& files) override {
    const Scene& scene = truth.scene;
    const std::string split = scene.splitFolder();
    const std::string beginning = split + "/" + scene.name;
    json right = contentsOf(scene);
    if (options_.webdataset) files.compareJson(beginning + ".json", right);
    const auto name = [&](const char* column, const std::string& end) {
      right[column] = asJsonHasIt(scene.name + end);
      return beginning + end;
    };
    files.compareWithScene(name("file_name", "." + options_.image_format), truth);
    if (options_.masks) {
      files.comparePicture(name("mask_file_name", ".mask.png"), scene.instance_map());
    }
    if (options_.depth) {
      files.compareWithScene(name("depth_file_name", ".depth.tiff"), truth, "depth");
    }
    if (options_.normals) {
      files.compareWithScene(name("normals_file_name", ".normals.png"), truth, "normals.colours");
    }
    if (options_.optical_flow) {
      compareFlow(name("flow_u_file_name", ".flow_u.tiff"),
                  name("flow_v_file_name", ".flow_v.tiff"), truth, files);
    }
    const std::string metadata = split + "/metadata.jsonl";
    const auto index = files.kept().get<LineIndex>(files.folder() / metadata);
    compareJson(index->line(right["file_name"].get<std::string>()), right,
                metadata + ", '" + scene.name + "'", files.differences());
    ++counts_[split];
  }

  void checkDataset(FoundFiles& files) override {
    for (const auto& [split, count] : counts_) {
      if (count == 0) continue;  // Hugging Face's loader refuses splits without images
      const std::string metadata = split + "/metadata.jsonl";
      if (!files.take(metadata)) continue;
      const std::size_t found = files.kept().get<LineIndex>(files.folder() / metadata)->count();
      if (found == count) continue;
      files.differences().add(metadata, std::to_string(found) + " lines", std::to_string(count));
    }
    compareCard(files);
  }

 private:
  static void compareFlow(const std::string& u_name, const std::string& v_name,
                          const TrueScene& truth, FoundFiles& files) {
    const auto u_file = files.take(u_name);
    const auto v_file = files.take(v_name);
    if (!u_file || !v_file) return;
    const std::vector<cv::Mat> parts = {readPicture(*u_file, cv::IMREAD_UNCHANGED),
                                        readPicture(*v_file, cv::IMREAD_UNCHANGED)};
    if (parts[0].size() != parts[1].size() || parts[0].type() != CV_32FC1 ||
        parts[1].type() != CV_32FC1) {
      files.differences().add(u_name + ": it and '" + v_name + "' should be of 32 bits and a size");
      return;
    }
    cv::Mat both;
    cv::merge(parts, both);
    files.comparePixels(u_name + " with '" + v_name + "'", both, truth, "optical_flow");
  }

  [[nodiscard]] json contentsOf(const Scene& scene) {
    return {{"width", scene.camera.width()}, {"height", scene.camera.height()},
            {"instant", scene.instant},      {"stamp_ns", scene.stamp.count()},
            {"camera", cameraOf(scene)},     {"objects", objectsOf(scene)}};
  }

  [[nodiscard]] static json cameraOf(const Scene& scene) {
    constexpr std::size_t kFewest = 8;  // coefficients in a list of ROS's
    const Intrinsics& k = scene.camera.intrinsics();
    const Distortion& distortion = scene.camera.distortion();
    std::vector<double> coefficients = coefficientsOf(distortion);
    while (coefficients.size() < kFewest) coefficients.push_back(0.0);
    return {{"name", asJsonHasIt(scene.camera_name)},
            {"K", {k.fx, 0.0, k.cx, 0.0, k.fy, k.cy, 0.0, 0.0, 1.0}},
            {"distortion_model", distortionModelName(distortion.model)},
            {"D", coefficients},
            {"X_GC", matrixOf(scene.X_GC)}};
  }

  [[nodiscard]] json objectsOf(const Scene& scene) const {
    json objects;
    for (const char* key :
         {"bbox", "categories", "class_names", "names", "ids", "instances", "visibility",
          "truncation", "distance", "X_CO", "cuboid", "keypoints", "keypoint_visibility"}) {
      objects[key] = json::array();
    }
    for (const SceneObject& object : scene.objects) {
      const auto box = boxOf(object, options_.box, scene.camera);
      if (object.labelled() && box) addObject(object, *box, objects);
    }
    return objects;
  }

  static void addObject(const SceneObject& object, const Box& box, json& objects) {
    objects["bbox"].push_back(
        {box.left + 0.5, box.top + 0.5, box.right - box.left, box.bottom - box.top});
    objects["categories"].push_back(object.class_id);
    objects["class_names"].push_back(asJsonHasIt(object.class_name));
    objects["names"].push_back(asJsonHasIt(object.name));
    objects["ids"].push_back(asJsonHasIt(object.id));
    objects["instances"].push_back(object.instance);
    objects["visibility"].push_back(object.visibility());
    objects["truncation"].push_back(object.truncation());
    objects["distance"].push_back(object.X_CO->translation().norm());
    objects["X_CO"].push_back(matrixOf(*object.X_CO));
    const auto& [low, high] = object.cuboid_O;
    objects["cuboid"].push_back({low.x(), low.y(), low.z(), high.x(), high.y(), high.z()});
    json places = json::array();
    json flags = json::array();
    for (const Keypoint& keypoint : object.keypoints) {
      const Eigen::Vector2d place = keypoint.pixel.value_or(Eigen::Vector2d::Zero());
      places.push_back({place.x(), place.y()});
      const KeypointState state = keypoint.pixel ? keypoint.state() : KeypointState::kOutside;
      flags.push_back(state == KeypointState::kOutside   ? 0
                      : state == KeypointState::kVisible ? 2
                                                         : 1);
    }
    objects["keypoints"].push_back(std::move(places));
    objects["keypoint_visibility"].push_back(std::move(flags));
  }

  /// The card's header names a fingerprint of all labels and images, which nothing else says.
  void compareCard(FoundFiles& files) const {
    const auto file = files.take("README.md");
    if (!file) return;
    const std::string found = readText(*file);
    DatasetCard card;
    card.classes = dataset_.classes;
    card.credits = dataset_.credits;
    for (const auto& split : dataset_.splitFolders()) {
      if (counts_.at(split) > 0) card.splits.push_back({split, 0});
    }
    const bool has_png = options_.image_format == "png" || options_.masks || options_.normals;
    if (has_png) card.extensions.emplace_back("png");
    if (options_.image_format == "jpg") card.extensions.emplace_back("jpg");
    if (options_.depth || options_.optical_flow) card.extensions.emplace_back("tiff");
    card.webdataset = options_.webdataset;
    const std::string before = "\"content ";
    const std::size_t at = found.find(before);
    if (at != std::string::npos) card.fingerprint = found.substr(at + before.size(), 16);
    std::ostringstream right;
    writeCard(right, card);
    compareText(found, right.str(), "README.md", files.differences());
  }

  ImageFolderOptions options_;
  DatasetInfo dataset_;
  std::map<std::string, std::size_t> counts_;  ///< of images, by split
};

}  // namespace

std::unique_ptr<ValueCheck> valueCheck(Parameters& parameters, const DatasetInfo& dataset) {
  return std::make_unique<ImageFolderValues>(readImageFolderOptions(parameters), dataset);
}

}  // namespace synthetic_dataset::formats::image_folder

#include <algorithm>
#include <array>
#include <iterator>
#include <ostream>
#include <vector>

#include <opencv2/core.hpp>
#include <pluginlib/class_list_macros.hpp>

#include "plugins/coco/coco_keypoints.h"
#include "plugins/image_folder/image_folder_card.h"
#include "plugins/image_folder/image_folder_options.h"
#include "plugins/shared/json.h"
#include "synthetic_dataset/box_choice.h"
#include "synthetic_dataset/fingerprint.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {
namespace {

/// The coefficients, padded with zeros to eight; more if the model has more.
std::vector<double> numbersOf(const Distortion& distortion) {
  constexpr std::size_t kUsual = 8;
  std::vector<double> numbers = coefficientsOf(distortion);
  numbers.resize(std::max(numbers.size(), kUsual));
  return numbers;
}

/// Unit normals as colours: red, green and blue are x, y and z from -1 (0) to 1 (255); black where
/// there is nothing.
cv::Mat normalPicture(const cv::Mat_<cv::Vec3f>& normals) {
  const auto colour = [](float coordinate) {
    return cv::saturate_cast<uchar>((coordinate + 1.0F) * 0.5F * 255.0F);
  };
  cv::Mat_<cv::Vec3b> picture(normals.size());
  std::transform(normals.begin(), normals.end(), picture.begin(), [&](const cv::Vec3f& n) {
    const bool is_nothing = n == cv::Vec3f();
    return is_nothing ? cv::Vec3b() : cv::Vec3b(colour(n[2]), colour(n[1]), colour(n[0]));
  });
  return picture;
}

cv::Mat channel(const cv::Mat& picture, int index) {
  cv::Mat result;
  cv::extractChannel(picture, result, index);
  return result;
}

/// What the writer keeps of a scene: a line of metadata, preceded by the split and the fingerprint.
struct ImageRecord {
  std::string split;
  std::string fingerprint;  ///< of the image
  std::string line;

  [[nodiscard]] std::string text() const { return split + "\n" + fingerprint + "\n" + line; }

  [[nodiscard]] static ImageRecord of(const std::string& text) {
    const std::size_t first = text.find('\n');
    const std::size_t second = text.find('\n', first + 1);
    return {text.substr(0, first), text.substr(first + 1, second - first - 1),
            text.substr(second + 1)};
  }
};

std::string fingerprintOf(const cv::Mat& image) {
  Fingerprint fingerprint;
  for (int row = 0; row < image.rows; ++row) {
    fingerprint.add(image.ptr(row), static_cast<std::size_t>(image.cols) * image.elemSize());
  }
  return fingerprint.text();
}

Json cameraOf(const Scene& scene) {
  const Intrinsics& k = scene.camera.intrinsics();
  return {{"name", scene.camera_name},
          {"K", {k.fx, 0.0, k.cx, 0.0, k.fy, k.cy, 0.0, 0.0, 1.0}},
          {"distortion_model", distortionModelName(scene.camera.distortion().model)},
          {"D", numbersOf(scene.camera.distortion())},
          {"X_GC", jsonMatrix(scene.X_GC)}};
}

}  // namespace

/// Hugging Face's `imagefolder`: one folder per split with its images and `metadata.jsonl`, one
/// line per image. With `webdataset`, each image's line is also in a file beside it, so that the
/// folder can be packed into WebDataset's shards: files that belong to an image differ from it only
/// after the first dot. https://huggingface.co/docs/datasets/image_dataset,
/// https://github.com/webdataset/webdataset
///
/// Every line has the same keys with values of the same types, as Arrow's JSON reader requires.
class ImageFolderWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset) override {
    options_ = readImageFolderOptions(parameters);
    has_keypoints_ = std::any_of(dataset.objects.begin(), dataset.objects.end(),
                                 [](const ObjectInfo& each) { return each.keypoint_count > 0; });
    card_.classes = dataset.classes;
    card_.credits = dataset.credits;
    // Hugging Face's loader refuses splits without images.
    std::copy_if(dataset.splits.begin(), dataset.splits.end(), std::back_inserter(card_.splits),
                 [](const SplitInfo& each) { return each.scene_count > 0; });
    if (dataset.splits.empty()) card_.splits = {{"train", dataset.scene_count}};
    if (options_.image_format == "png" || options_.masks || options_.normals)
      card_.extensions.emplace_back("png");
    if (options_.image_format == "jpg") card_.extensions.emplace_back("jpg");
    if (options_.depth || options_.optical_flow) card_.extensions.emplace_back("tiff");
    card_.webdataset = options_.webdataset;
  }

  [[nodiscard]] Requirements doRequirements() const override {
    Requirements requirements = requirementsOf(options_.box);
    requirements.visibility = true;
    requirements.keypoint_states = has_keypoints_;
    requirements.depth = options_.depth;
    requirements.normals = options_.normals;
    requirements.optical_flow = options_.optical_flow;
    return requirements;
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    const std::string split = scene.splitFolder();
    Json line = Json::object();
    const auto add = [&](const std::string& column, const std::string& end, const cv::Mat& image) {
      output.addImage(split + "/" + scene.name + end, image);
      line[column] = scene.name + end;
    };
    add("file_name", "." + options_.image_format, scene.image);
    if (options_.masks) add("mask_file_name", ".mask.png", scene.instance_map());
    if (options_.depth) add("depth_file_name", ".depth.tiff", scene.depth());
    if (options_.normals) add("normals_file_name", ".normals.png", normalPicture(scene.normals()));
    if (options_.optical_flow) {
      add("flow_u_file_name", ".flow_u.tiff", channel(scene.optical_flow(), 0));
      add("flow_v_file_name", ".flow_v.tiff", channel(scene.optical_flow(), 1));
    }
    const Json contents = contentsOf(scene);
    line.update(contents);
    const ImageRecord record{split, fingerprintOf(scene.image), jsonText(line)};
    output.addRecord(kImages, record.text());
    if (options_.webdataset)
      output.addText(split + "/" + scene.name + ".json", jsonText(contents) + "\n");
  }

  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    for (const SplitInfo& split : card_.splits) {
      output.addFile(split.name + "/metadata.jsonl", [&](std::ostream& file) {
        records.forEach(kImages, [&](std::int64_t /*scene*/, const std::string& text) {
          const ImageRecord record = ImageRecord::of(text);
          if (record.split == split.name) file << record.line << '\n';
        });
      });
    }
    Fingerprint fingerprint;
    records.forEach(kImages, [&](std::int64_t /*scene*/, const std::string& text) {
      fingerprint.add(text.data(), text.size());
    });
    DatasetCard card = card_;
    card.fingerprint = fingerprint.text();
    output.addFile("README.md", [&](std::ostream& file) { writeCard(file, card); });
  }

  [[nodiscard]] Json contentsOf(const Scene& scene) const {
    return {{"width", scene.camera.width()}, {"height", scene.camera.height()},
            {"instant", scene.instant},      {"stamp_ns", scene.stamp.count()},
            {"camera", cameraOf(scene)},     {"objects", objectsOf(scene)}};
  }

  /// One list per property, with an entry for each labelled object.
  [[nodiscard]] Json objectsOf(const Scene& scene) const {
    Json objects = Json::object();
    for (const char* key :
         {"bbox", "categories", "class_names", "names", "ids", "instances", "visibility",
          "truncation", "distance", "X_CO", "cuboid", "keypoints", "keypoint_visibility"}) {
      objects[key] = Json::array();
    }
    for (const SceneObject& object : scene.objects) {
      const auto box = boxOf(object, options_.box, scene.camera);
      if (!object.labelled() || !box) continue;
      objects["bbox"].push_back(cocoBox(*box));
      objects["categories"].push_back(object.class_id);
      objects["class_names"].push_back(object.class_name);
      objects["names"].push_back(object.name);
      objects["ids"].push_back(object.id);
      objects["instances"].push_back(object.instance);
      objects["visibility"].push_back(object.visibility());
      objects["truncation"].push_back(object.truncation());
      objects["distance"].push_back(object.distance());
      objects["X_CO"].push_back(jsonMatrix(*object.X_CO));
      const auto& [low, high] = object.cuboid_O;
      objects["cuboid"].push_back({low.x(), low.y(), low.z(), high.x(), high.y(), high.z()});
      Json places = Json::array();
      Json flags = Json::array();
      for (const Keypoint& keypoint : object.keypoints) {
        const Eigen::Vector2d place = keypoint.pixel.value_or(Eigen::Vector2d::Zero());
        places.push_back({place.x(), place.y()});
        flags.push_back(cocoFlag(keypoint));
      }
      objects["keypoints"].push_back(std::move(places));
      objects["keypoint_visibility"].push_back(std::move(flags));
    }
    return objects;
  }

  static constexpr const char* kImages = "images";  // channel of all records, for the fingerprint

  ImageFolderOptions options_;
  bool has_keypoints_ = false;
  DatasetCard card_;
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::ImageFolderWriter, synthetic_dataset::LabelWriter)

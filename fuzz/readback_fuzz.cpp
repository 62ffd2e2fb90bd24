// The files of datasets. The first byte selects the format, A for the first; the pieces after it
// are the text files that the format has for a scene, and a last one may be the scene's picture.
#include <map>
#include <set>

#include <opencv2/imgcodecs.hpp>

#include "fuzzing.h"
#include "plugins/readback/format.h"
#include "plugins/readback/label_overlay.h"

namespace {

using namespace synthetic_dataset;
using Names = std::vector<std::string>;

/// The files of a scene called 000000.
struct Format {
  std::string type;
  std::string image;
  Names masks;     ///< 8 bits
  Names texts;     ///< in the order of the input's pieces
  Names listed{};  ///< of `texts`: those that the manifest lists as the scene's
};

const std::vector<Format> kFormats = {
    {"Bop",
     "train/000000/rgb/000000.png",
     {"train/000000/mask_visib/000000_000000.png"},
     {"train/000000/scene_camera.json", "train/000000/scene_gt_info.json",
      "train/000000/scene_gt.json", "models/models_info.json"}},
    {"Cityscapes",
     "leftImg8bit/train/a/a_000000_leftImg8bit.png",
     {"gtFine/train/a/a_000000_gtFine_instanceIds.png"},
     {"labels.json"}},
    {"Coco", "images/000000.png", {}, {"annotations/instances_train.json"}},
    {"Dope", "000000.png", {}, {"000000.json"}, {"000000.json"}},
    {"ImageFolder", "train/000000.png", {"train/masks/000000.png"}, {"train/metadata.jsonl"}},
    {"Kitti",
     "training/image_2/000000.png",
     {},
     {"training/label_2/000000.txt", "training/calib/000000.txt"}},
    {"PascalVoc",
     "JPEGImages/000000.png",
     {"SegmentationObject/000000.png"},
     {"Annotations/000000.xml"},
     {"Annotations/000000.xml"}},
    {"PvNet",
     "robot/scenes/rgb/000000.png",
     {"robot/scenes/mask/000000.png"},
     {"robot/camera.txt", "robot/corners.txt", "robot/fps.txt", "robot/scenes/pose/000000.npy"}},
    {"StvNet",
     "robot/JPEGImages/000000.png",
     {"robot/mask/000000.png"},
     {"robot/labels/000000.txt"}},
    {"UltralyticsYolo",
     "images/train/000000.png",
     {},
     {"labels/train/000000.txt", "data.yaml"},
     {"labels/train/000000.txt"}},
    {"Yolo", "000000.png", {}, {"000000.txt"}, {"000000.txt"}},
    {"BoundingShape", "000000.png", {}, {"000000.txt"}, {"000000.txt"}},
    {"KittiTracking",
     "scenes/000000.png",
     {"training/image_02/0000/000000.png"},
     {"frames.txt", "training/label_02/0000.txt", "training/calib/0000.txt"}},
    {"LabelMe", "train/000000.png", {}, {"train/000000.json"}, {"train/000000.json"}},
    {"Mot",
     "scenes/000000.png",
     {"train/camera/img1/000001.png"},
     {"frames.txt", "train/camera/gt/gt.txt", "train/camera/gt/labels.txt"}},
    {"NuScenes",
     "samples/CAM_FRONT/000000.png",
     {},
     {"v1.0-trainval/image_annotations.json", "v1.0-trainval/sample_annotation.json",
      "v1.0-trainval/sample_data.json", "v1.0-trainval/calibrated_sensor.json",
      "v1.0-trainval/ego_pose.json"}},
};

std::string png(int type) {
  std::vector<unsigned char> bytes;
  cv::imencode(".png", cv::Mat(12, 16, type, cv::Scalar(26, 26, 26)), bytes);
  return {bytes.begin(), bytes.end()};
}

void read(const Format& format, const Names& contents) {
  static const std::string kImage = png(CV_8UC3);
  static const std::string kMask = png(CV_8UC1);
  static const std::string kInstances = png(CV_16UC1);
  const std::size_t texts = format.texts.size();
  formats::WrittenScene scene;
  scene.folder = fuzzing::folder() / format.type;
  scene.name = "000000";
  const auto write = [&](const std::string& name, const std::string& content) {
    return fuzzing::write(format.type + "/" + name, content);
  };
  for (std::size_t i = 0; i < texts; ++i) {
    write(format.texts[i], i < contents.size() ? contents[i] : "");
  }
  for (const std::string& name : format.listed) scene.files.push_back(scene.folder / name);
  const std::string given = contents.size() > texts ? contents[texts] : "";
  scene.files.push_back(write(format.image, given.empty() ? kImage : given));
  for (const std::string& name : format.masks) {
    scene.files.push_back(write(name, format.type == "Cityscapes" ? kInstances : kMask));
  }
  static_cast<void>(drawLabels(formats::formatOf("synthetic_dataset/" + format.type)->read(scene)));
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  // A byte stays that of its format when others are added.
  const Format& format = kFormats[(data[0] + kFormats.size() * 256U - 'A') % kFormats.size()];
  const Names contents = fuzzing::pieces(fuzzing::view(data + 1, size - 1));
  fuzzing::tolerating([&] { read(format, contents); });
  return 0;
}

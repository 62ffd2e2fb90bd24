#include "plugins/bop/bop_scenes.h"

#include <map>
#include <ostream>

namespace synthetic_dataset {
namespace {

/// Entries of a JSON list or map, one per line.
class Entries {
 public:
  void add(const std::string& entry) { text_ += (text_.empty() ? "" : ",\n") + entry; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// The contents of a folder's files, collected so far.
struct SceneFolder {
  Entries cameras;
  Entries poses;
  Entries infos;
  Entries coco_images;
  Entries annotations;
  std::int64_t annotation_count = 0;

  void add(const BopImage& image) {
    const std::string key = "\"" + std::to_string(image.im_id) + "\": ";
    cameras.add(key + image.camera.dump());
    poses.add(key + image.poses.dump());
    infos.add(key + image.infos.dump());
    coco_images.add(image.coco_image.dump());
    for (Json annotation : image.annotations) {
      annotation["id"] = ++annotation_count;  // from 1: pycocotools takes 0 for no match
      annotations.add(annotation.dump());
    }
  }
};

using SceneFolders = std::map<std::string, SceneFolder>;

void addFiles(const SceneFolders& folders, const Json& coco_header, DatasetOutput& output) {
  for (const auto& each : folders) {
    const std::string& path = each.first;
    const SceneFolder& folder = each.second;
    const auto addMap = [&](const char* name, const Entries& entries) {
      output.addText(path + name, "{\n" + entries.text() + "\n}\n");
    };
    addMap("/scene_camera.json", folder.cameras);
    addMap("/scene_gt.json", folder.poses);
    addMap("/scene_gt_info.json", folder.infos);
    if (coco_header.is_null()) continue;
    output.addFile(path + "/scene_gt_coco.json", [&](std::ostream& stream) {
      stream << "{\n";
      for (const auto& member : coco_header.items()) {
        stream << '"' << member.key() << "\": " << member.value().dump() << ",\n";
      }
      stream << "\"images\": [\n"
             << folder.coco_images.text() << "],\n\"annotations\": [\n"
             << folder.annotations.text() << "]\n}\n";
    });
  }
}

}  // namespace

std::string BopImage::record() const {
  return Json::array(
             {split, folder, series, im_id, camera, poses, infos, coco_image, annotations, targets})
      .dump();
}

BopImage BopImage::fromRecord(const std::string& record) {
  const Json json = parsedJson<Json>(record);
  BopImage image;
  json.at(0).get_to(image.split);
  json.at(1).get_to(image.folder);
  json.at(2).get_to(image.series);
  json.at(3).get_to(image.im_id);
  image.camera = json.at(4);
  image.poses = json.at(5);
  image.infos = json.at(6);
  image.coco_image = json.at(7);
  image.annotations = json.at(8);
  image.targets = json.at(9);
  return image;
}

void addBopSceneFiles(const SceneRecords& records, const Json& coco_header, DatasetOutput& output) {
  SceneFolders folders;
  std::int64_t series = 0;
  records.forEach(kImages, [&](std::int64_t /*scene*/, const std::string& record) {
    const BopImage image = BopImage::fromRecord(record);
    if (image.series != series) {
      addFiles(folders, coco_header, output);
      folders.clear();
      series = image.series;
    }
    folders[image.folder].add(image);
  });
  addFiles(folders, coco_header, output);
}

void addBopTargets(const SceneRecords& records, const std::string& split, DatasetOutput& output) {
  output.addFile("test_targets_bop19.json", [&](std::ostream& stream) {
    stream << "[";
    const char* separator = "\n";
    records.forEach(kImages, [&](std::int64_t /*scene*/, const std::string& record) {
      const BopImage image = BopImage::fromRecord(record);
      if (image.split != split) return;
      for (const Json& target : image.targets) {
        stream << separator << target.dump();
        separator = ",\n";
      }
    });
    stream << "\n]\n";
  });
}

}  // namespace synthetic_dataset

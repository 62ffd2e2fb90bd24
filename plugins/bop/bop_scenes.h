#pragma once

#include <string>

#include "plugins/shared/json.h"
#include "synthetic_dataset/label_writer.h"

/// The JSON files of BOP's scene folders, gathered folder by folder from the records of images.
namespace synthetic_dataset {

inline constexpr const char* kImages = "images";  ///< the channel of all records

/// The contribution of one image to the JSON files of its folder.
struct BopImage {
  std::string split;        ///< "train"
  std::string folder;       ///< "train/000000"
  std::int64_t series = 0;  ///< images of later series are in other folders
  std::int64_t im_id = 0;
  Json camera;       ///< for scene_camera.json
  Json poses;        ///< for scene_gt.json
  Json infos;        ///< for scene_gt_info.json
  Json coco_image;   ///< for scene_gt_coco.json
  Json annotations;  ///< for scene_gt_coco.json, a list without `id`
  Json targets;      ///< for the list of test targets

  [[nodiscard]] std::string record() const;
  [[nodiscard]] static BopImage fromRecord(const std::string& record);
};

/// Writes scene_camera.json, scene_gt.json, scene_gt_info.json and scene_gt_coco.json for every
/// folder. Holds the contributions of one series of images in memory.
/// @param coco_header  the members of scene_gt_coco.json besides images and annotations; null: no
///     such file
void addBopSceneFiles(const SceneRecords& records, const Json& coco_header, DatasetOutput& output);

/// Writes the list of targets to be found in the images of a split.
void addBopTargets(const SceneRecords& records, const std::string& split, DatasetOutput& output);

}  // namespace synthetic_dataset

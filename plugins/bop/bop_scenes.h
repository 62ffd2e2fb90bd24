#pragma once

#include <string>

#include "plugins/shared/json.h"
#include "synthetic_dataset/label_writer.h"

/// The JSON files of BOP's scene folders: what images leave in records, gathered folder by folder.
namespace synthetic_dataset {

inline constexpr const char* kImages = "images";  ///< the channel of all records

/// What one image adds to the JSON files of the folder that it is in.
struct BopImage {
  std::string split;        ///< "train"
  std::string folder;       ///< "train/000000"
  std::int64_t series = 0;  ///< images of later series are in other folders
  std::int64_t im_id = 0;
  Json camera;       ///< of scene_camera.json
  Json poses;        ///< of scene_gt.json
  Json infos;        ///< of scene_gt_info.json
  Json coco_image;   ///< of scene_gt_coco.json
  Json annotations;  ///< of the same, a list without `id`
  Json targets;      ///< of the list of test targets

  [[nodiscard]] std::string record() const;
  [[nodiscard]] static BopImage fromRecord(const std::string& record);
};

/// The files scene_camera.json, scene_gt.json, scene_gt_info.json and scene_gt_coco.json of every
/// folder. Holds what one series of images adds in memory.
/// @param coco_header  the members of scene_gt_coco.json besides images and annotations; null: no
///     such file
void addBopSceneFiles(const SceneRecords& records, const Json& coco_header, DatasetOutput& output);

/// The list of what is to be found in the images of a split.
void addBopTargets(const SceneRecords& records, const std::string& split, DatasetOutput& output);

}  // namespace synthetic_dataset

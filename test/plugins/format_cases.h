#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset {

/// A format with settings; the tests of all formats run with each of these.
struct FormatCase {
  std::string name;  ///< of the test
  std::string type;  ///< "Yolo"
  Value::Map parameters = {};
  std::int64_t labels_of_a_scene = 2;  ///< for a scene in which two objects are seen
  bool has_lidar = false;              ///< it writes the clouds of a lidar "top"
  bool is_of_all_cameras = false;      ///< it has one file per instant for all cameras
  std::size_t remarks = 0;             ///< of verify: files that are checked by digest only
};

inline std::ostream& operator<<(std::ostream& stream, const FormatCase& format) {
  return stream << format.name;
}

/// @return  each format of the package, at least once
inline std::vector<FormatCase> formatCases() {
  return {
      {"Bop", "Bop"},
      {"BoundingShape", "BoundingShape", {{"output_frame", "map"}}},
      {"Cityscapes", "Cityscapes"},
      {"CityscapesOwn", "Cityscapes", {{"label_ids", Value::Map{{"cup", 26}}}}},
      {"Coco", "Coco", {{"panoptic", true}}},
      {"CocoPadded",
       "Coco",
       {{"panoptic", true},
        {"background", "world"},
        {"pad_keypoints", true},
        {"annotation_file", "person_keypoints"}}},
      {"CocoPolygons", "Coco", {{"segmentation", "polygons"}, {"box", "silhouette"}}},
      {"Dope", "Dope"},
      {"Ndds", "Dope", {{"style", "ndds"}, {"box", "loose"}}},
      {"ImageFolder", "ImageFolder", {{"depth", true}, {"masks", true}}},
      {"ImageFolderJpeg", "ImageFolder", {{"image_format", "jpg"}, {"webdataset", true}}},
      {"Kitti", "Kitti", {{"class_names", Value::Map{{"cup", "Car"}}}}},
      {"KittiVelodyne", "Kitti", {{"velodyne", "depth"}}},
      {"KittiLidar", "Kitti", {{"velodyne", "top"}, {"min_points", 2}}, 2, true},
      {"KittiTracking", "KittiTracking", {{"class_names", Value::Map{{"cup", "Car"}}}}},
      {"KittiTrackingLidar",
       "KittiTracking",
       {{"class_names", Value::Map{{"cup", "Car"}}}, {"velodyne", "top"}},
       2,
       true},
      {"LabelMe", "LabelMe"},
      {"LabelMeRectangles", "LabelMe", {{"shape", "rectangle"}, {"box", "silhouette"}}},
      {"Mot", "Mot"},
      {"MotPng", "Mot", {{"image_format", "png"}, {"class_ids", Value::Map{{"cup", 3}}}}},
      {"NuScenes", "NuScenes"},
      {"NuScenesPng", "NuScenes", {{"image_format", "png"}, {"version", "v1.0-mini"}}},
      {"NuScenesLidar", "NuScenes", {{"min_points", 2}}, 2, true, false, 1},
      {"PascalVoc", "PascalVoc", {{"segmentation", true}}, 4},  // a mask apart from each box
      {"PascalVocFromZero", "PascalVoc", {{"coordinates", "zero_based"}, {"box", "loose"}}, 4},
      {"PvNet", "PvNet"},
      {"RosBag", "RosBag"},
      {"SemanticKitti", "SemanticKitti", {}, 2, true, true},
      {"SemanticKittiOwn",
       "SemanticKitti",
       {{"class_ids", Value::Map{{"cup", 10}}}, {"motion_corrected", false}},
       2,
       true,
       true},
      {"StvNet", "StvNet"},
      {"StvNetFromEdge", "StvNet", {{"pixel_origin", "edge"}}},
      {"UltralyticsDetect", "UltralyticsYolo", {{"task", "detect"}}},
      {"UltralyticsObb", "UltralyticsYolo", {{"task", "obb"}}},
      {"UltralyticsPose", "UltralyticsYolo", {{"task", "pose"}}},
      {"UltralyticsSegment", "UltralyticsYolo", {{"task", "segment"}}},
      {"Yolo", "Yolo", {{"main_list", "list.txt"}, {"cut_to_image", true}}},
      {"YoloNumbers", "Yolo", {{"main_list", "list.txt"}, {"class", "number"}}},
      {"YoloUncut", "Yolo", {{"main_list", "list.txt"}, {"cut_to_image", false}}},
      {"YoloFromEdge", "Yolo", {{"main_list", "list.txt"}, {"pixel_origin", "edge"}}},
  };
}

}  // namespace synthetic_dataset

#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// The content of `data.yaml`, which Ultralytics' loader reads.
/// https://docs.ultralytics.com/datasets/, ultralytics/data/utils.py (check_det_dataset)
struct UltralyticsDataset {
  std::vector<std::string> splits;                  ///< that have images, train first
  std::vector<std::string> names;                   ///< of classes, by number from 0
  std::size_t keypoint_count = 0;                   ///< of each object; 0 unless the task is pose
  std::vector<std::size_t> flip_idx;                ///< keypoint_count entries
  std::vector<std::vector<std::string>> kpt_names;  ///< for each class, keypoint_count names
};

/// The keypoint columns in a label's line: all classes have the same number of columns.
struct KeypointColumns {
  std::vector<std::vector<std::string>> names;  ///< of each class, "unused_<column>" at the end
  std::vector<std::vector<std::size_t>>
      of_objects;  ///< the column of each of an object's keypoints
};

/// A class's columns are all names of its objects' keypoints, in order of first occurrence, so that
/// a name has the same column in all objects of the class.
[[nodiscard]] KeypointColumns keypointColumns(const DatasetInfo& dataset, std::size_t class_count);

void writeUltralyticsYaml(std::ostream& stream, const UltralyticsDataset& dataset);

}  // namespace synthetic_dataset

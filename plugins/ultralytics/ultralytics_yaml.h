#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// What Ultralytics' loader reads of a dataset, in `data.yaml`.
/// https://docs.ultralytics.com/datasets/, ultralytics/data/utils.py (check_det_dataset)
struct UltralyticsDataset {
  std::vector<std::string> splits;                  ///< that have images, train first
  std::vector<std::string> names;                   ///< of classes, by their numbers from 0
  std::size_t keypoint_count = 0;                   ///< of each object; 0 unless the task is pose
  std::vector<std::size_t> flip_idx;                ///< as many
  std::vector<std::vector<std::string>> kpt_names;  ///< for each class as many
};

/// Where keypoints stand in a label's line: all classes have as many columns.
struct KeypointColumns {
  std::vector<std::vector<std::string>> names;  ///< of each class, "unused_<column>" at the end
  std::vector<std::vector<std::size_t>>
      of_objects;  ///< the column of each of an object's keypoints
};

/// A class's columns are all names that its objects' keypoints have, in the order in which they
/// come up: a name has the same column in all of its objects.
[[nodiscard]] KeypointColumns keypointColumns(const DatasetInfo& dataset, std::size_t class_count);

void writeUltralyticsYaml(std::ostream& stream, const UltralyticsDataset& dataset);

}  // namespace synthetic_dataset

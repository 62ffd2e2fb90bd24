#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "plugins/coco/coco_options.h"
#include "synthetic_dataset/label_writer.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::formats::coco {

/// The keypoints that classes and annotations should have: a name that an object has for the second
/// time is another keypoint than the first of this name.
class TrueKeypoints {
 public:
  TrueKeypoints(const DatasetInfo& dataset, const CocoOptions& options);

  [[nodiscard]] bool any() const;

  /// The members of a category.
  void addTo(nlohmann::json& category, int class_id) const;

  /// The members of an annotation.
  void addTo(nlohmann::json& annotation, const SceneObject& object) const;

 private:
  /// Of a class.
  struct Columns {
    std::map<std::pair<std::string, int>, std::size_t> indices;  ///< by name and its repetition
    std::vector<std::string> names;
    std::set<std::pair<std::size_t, std::size_t>> known_lines;
    nlohmann::json lines = nlohmann::json::array();
  };

  void pad(const DatasetInfo& dataset);

  std::map<int, Columns> classes_;
  std::vector<std::vector<std::size_t>> of_objects_;
};

}  // namespace synthetic_dataset::formats::coco

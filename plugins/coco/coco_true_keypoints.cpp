#include "plugins/coco/coco_true_keypoints.h"

#include <algorithm>

#include "plugins/readback/json_text.h"

namespace synthetic_dataset::formats::coco {

using nlohmann::json;

TrueKeypoints::TrueKeypoints(const DatasetInfo& dataset, const CocoOptions& options) {
  const std::vector<std::string>& asked_for = options.keypoint_classes;
  for (const ObjectInfo& object : dataset.objects) {
    of_objects_.emplace_back();
    const bool is_asked_for = asked_for.empty() || std::find(asked_for.begin(), asked_for.end(),
                                                             object.class_name) != asked_for.end();
    if (!options.keypoints || !is_asked_for) continue;
    Columns& of_class = classes_[object.class_id];
    std::map<std::string, int> counts;
    std::vector<std::size_t> columns;
    for (const std::string& name : object.keypoint_names) {
      const auto [known, is_new] =
          of_class.indices.try_emplace({name, counts[name]++}, of_class.names.size());
      if (is_new) of_class.names.push_back(name);
      columns.push_back(known->second);
    }
    for (const auto& [from, to] : object.skeleton) {
      const std::pair<std::size_t, std::size_t> line(columns.at(from) + 1, columns.at(to) + 1);
      if (of_class.known_lines.insert(line).second) {
        of_class.lines.push_back({line.first, line.second});
      }
    }
    of_objects_.back() = std::move(columns);
  }
  if (options.keypoints && options.pad_keypoints) pad(dataset);
}

bool TrueKeypoints::any() const {
  return std::any_of(classes_.begin(), classes_.end(),
                     [](const auto& each) { return !each.second.names.empty(); });
}

void TrueKeypoints::addTo(json& category, int class_id) const {
  const auto found = classes_.find(class_id);
  if (found == classes_.end() || found->second.names.empty()) return;
  category["keypoints"] = json::array();
  for (const std::string& name : found->second.names) {
    category["keypoints"].push_back(asJsonHasIt(name));
  }
  category["skeleton"] = found->second.lines;
}

void TrueKeypoints::addTo(json& annotation, const SceneObject& object) const {
  const std::vector<std::size_t>& columns =
      of_objects_.at(static_cast<std::size_t>(object.instance - 1));
  const auto of_class = classes_.find(object.class_id);
  const std::size_t count = of_class == classes_.end() ? 0 : of_class->second.names.size();
  json numbers = json::array();
  for (std::size_t i = 0; i < count; ++i) numbers.insert(numbers.end(), {0.0, 0.0, 0});
  int in_image = 0;
  for (std::size_t i = 0; i < std::min(columns.size(), object.keypoints.size()); ++i) {
    const Keypoint& keypoint = object.keypoints[i];
    if (!keypoint.pixel || keypoint.state() == KeypointState::kOutside) continue;
    ++in_image;
    const std::size_t at = 3 * columns[i];
    numbers[at] = keypoint.pixel->x();
    numbers[at + 1] = keypoint.pixel->y();
    numbers[at + 2] = keypoint.state() == KeypointState::kVisible ? 2 : 1;
  }
  annotation["keypoints"] = std::move(numbers);
  annotation["num_keypoints"] = in_image;
}

/// With names for what no object of a class has.
void TrueKeypoints::pad(const DatasetInfo& dataset) {
  std::size_t most = 0;
  for (const auto& [id, columns] : classes_) most = std::max(most, columns.names.size());
  for (const ClassInfo& each : dataset.classes) {
    std::vector<std::string>& names = classes_[each.id].names;
    for (std::size_t i = names.size(); i < most; ++i) {
      names.push_back("unused_" + std::to_string(i));
    }
  }
}

}  // namespace synthetic_dataset::formats::coco

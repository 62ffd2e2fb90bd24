#include "plugins/coco/coco_keypoints.h"

#include <algorithm>

namespace synthetic_dataset {
namespace {

/// The place in `names` of each of an object's names; those that lack there are added. A name that
/// an object has twice stands there twice.
std::vector<std::size_t> placesIn(std::vector<std::string>& names,
                                  const std::vector<std::string>& of_object) {
  std::vector<std::size_t> places;
  for (const std::string& name : of_object) {
    std::size_t place = 0;
    while (place < names.size() && (names[place] != name || std::find(places.begin(), places.end(),
                                                                      place) != places.end())) {
      ++place;
    }
    if (place == names.size()) names.push_back(name);
    places.push_back(place);
  }
  return places;
}

}  // namespace

CocoKeypoints::CocoKeypoints(const DatasetInfo& dataset, const std::vector<std::string>& of_classes,
                             bool is_padded) {
  for (const ObjectInfo& object : dataset.objects) {
    class_of_object_.push_back(object.class_id);
    name_places_.emplace_back();
    if (object.keypoint_names.empty()) continue;
    const bool is_asked_for =
        of_classes.empty() ||
        std::any_of(dataset.classes.begin(), dataset.classes.end(), [&](const ClassInfo& each) {
          return each.id == object.class_id &&
                 std::find(of_classes.begin(), of_classes.end(), each.name) != of_classes.end();
        });
    if (!is_asked_for) continue;
    ClassKeypoints& keypoints = classes_[object.class_id];
    const std::vector<std::size_t> places = placesIn(keypoints.names, object.keypoint_names);
    for (const auto& [from, to] : object.skeleton) {
      const std::array<std::size_t, 2> line = {places[from], places[to]};
      auto& lines = keypoints.skeleton;
      if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
    }
    name_places_.back() = places;
  }
  if (is_padded) pad(dataset.classes);
}

/// Names for what no object of a class has.
void CocoKeypoints::pad(const std::vector<ClassInfo>& classes) {
  std::size_t most = 0;
  for (const auto& [class_id, keypoints] : classes_) most = std::max(most, keypoints.names.size());
  for (const ClassInfo& each : classes) {
    std::vector<std::string>& names = classes_[each.id].names;
    while (names.size() < most) names.push_back("unused_" + std::to_string(names.size()));
  }
}

const ClassKeypoints& CocoKeypoints::of(int class_id) const {
  static const ClassKeypoints kNoKeypoints;
  const auto found = classes_.find(class_id);
  return found == classes_.end() ? kNoKeypoints : found->second;
}

std::vector<std::size_t> CocoKeypoints::places(std::size_t object) const {
  const std::vector<std::size_t>& name_places = name_places_[object];
  std::vector<std::size_t> places(of(class_of_object_[object]).names.size(), kNone);
  for (std::size_t i = 0; i < name_places.size(); ++i) places[name_places[i]] = i;
  return places;
}

}  // namespace synthetic_dataset

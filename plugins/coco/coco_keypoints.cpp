#include "plugins/coco/coco_keypoints.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace synthetic_dataset {
namespace {

/// A class's keypoints while those of its objects are being gathered. If an object has a name
/// twice, these are two different keypoints.
struct Gathered {
  std::map<std::pair<std::string, int>, std::size_t> places;  ///< by name and its occurrence
  std::set<std::array<std::size_t, 2>> lines;
};

/// The index in `names` of each of an object's names; missing ones are added.
std::vector<std::size_t> placesIn(ClassKeypoints& keypoints, Gathered& gathered,
                                  const std::vector<std::string>& of_object) {
  std::map<std::string, int> counts;
  std::vector<std::size_t> places;
  for (const std::string& name : of_object) {
    const auto [known, is_new] =
        gathered.places.try_emplace({name, counts[name]++}, keypoints.names.size());
    if (is_new) keypoints.names.push_back(name);
    places.push_back(known->second);
  }
  return places;
}

}  // namespace

CocoKeypoints::CocoKeypoints(const DatasetInfo& dataset, const std::vector<std::string>& of_classes,
                             bool is_padded) {
  std::map<int, Gathered> gathered;
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
    Gathered& of_class = gathered[object.class_id];
    const std::vector<std::size_t> places = placesIn(keypoints, of_class, object.keypoint_names);
    for (const auto& [from, to] : object.skeleton) {
      const std::array<std::size_t, 2> line = {places[from], places[to]};
      if (of_class.lines.insert(line).second) keypoints.skeleton.push_back(line);
    }
    name_places_.back() = places;
  }
  if (is_padded) pad(dataset.classes);
}

/// Adds names for keypoints that no object of a class has.
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

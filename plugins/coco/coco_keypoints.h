#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// COCO's visibility flag: 0 not in the image, 1 hidden, 2 visible.
[[nodiscard]] inline int cocoFlag(const Keypoint& keypoint) {
  if (!keypoint.pixel || keypoint.state() == KeypointState::kOutside) return 0;
  return keypoint.state() == KeypointState::kVisible ? 2 : 1;
}

/// COCO's keypoints belong to classes: all objects of a class have the same ones, in the same
/// order.
struct ClassKeypoints {
  std::vector<std::string> names;  ///< of all its objects' keypoints, without repetition
  std::vector<std::array<std::size_t, 2>> skeleton;  ///< indices into `names`, each pair once
};

class CocoKeypoints {
 public:
  /// Without keypoints.
  CocoKeypoints() = default;

  /// @param of_classes  names of the classes that have keypoints; empty: all
  /// @param is_padded  whether all classes have as many names as the class with the most
  CocoKeypoints(const DatasetInfo& dataset, const std::vector<std::string>& of_classes,
                bool is_padded);

  /// Whether any class has keypoints.
  [[nodiscard]] bool any() const {
    return std::any_of(classes_.begin(), classes_.end(),
                       [](const auto& each) { return !each.second.names.empty(); });
  }

  /// The keypoints of a class; empty if its objects have none.
  [[nodiscard]] const ClassKeypoints& of(int class_id) const;

  /// The keypoints of an object in its class's order: for each of the class's names, the index in
  /// the object's own list, or `kNone` if it has no such keypoint.
  /// @param object  its index in DatasetInfo::objects
  [[nodiscard]] std::vector<std::size_t> places(std::size_t object) const;

  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

 private:
  void pad(const std::vector<ClassInfo>& classes);

  std::map<int, ClassKeypoints> classes_;  // only classes that have keypoints
  std::vector<int> class_of_object_;
  std::vector<std::vector<std::size_t>> name_places_;  // in its class, by object, keypoint
};

}  // namespace synthetic_dataset

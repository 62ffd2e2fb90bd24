#include "plugins/semantic_kitti/semantic_kitti_classes.h"

#include <set>

#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset {

SemanticKittiClasses::SemanticKittiClasses(Parameters& parameters, const DatasetInfo& dataset) {
  constexpr int kLargest = 65535;  // 16 bits of a label
  std::vector<std::string> classes;
  for (const ClassInfo& each : dataset.classes) classes.push_back(each.name);
  const std::size_t object_classes = classes.size();
  classes.insert(classes.end(), dataset.world_classes.begin(), dataset.world_classes.end());

  std::map<std::string, std::uint32_t> given;
  Parameters group = parameters.group("class_ids");
  const std::set<std::string> known(classes.begin(), classes.end());
  for (const std::string& name : group.names()) {
    const auto number = group.maybeBetween<int>(name, 1, kLargest);
    if (known.count(name) == 0) {
      group.addError(
          name, "no object and no part of the world has this class" + didYouMean(name, classes));
    } else if (number) {
      given[name] = static_cast<std::uint32_t>(*number);
    }
  }
  std::set<std::uint32_t> taken;
  for (const auto& [name, number] : given) taken.insert(number);
  names_[0] = "unlabeled";
  of_objects_ = of_world_ = {0};
  std::uint32_t next = 1;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const auto found = given.find(classes[i]);
    while (found == given.end() && taken.count(next) != 0) ++next;
    const std::uint32_t number = found != given.end() ? found->second : next;
    taken.insert(number);
    // Classes may share a number, for example trucks and buses that the user regards as one class.
    names_.emplace(number, classes[i]);
    (i < object_classes ? of_objects_ : of_world_).push_back(number);
  }
}

std::uint32_t SemanticKittiClasses::numberOf(const CloudPoint& point) const {
  if (point.class_number > 0) return of_objects_.at(point.class_number);
  return of_world_.at(point.world_class);
}

std::optional<SemanticKittiClasses::Meaning> SemanticKittiClasses::meaningOf(
    std::uint32_t number) const {
  if (number == 0) return Meaning{};
  std::optional<Meaning> meaning;
  for (std::size_t i = 1; i < of_objects_.size() + of_world_.size() - 1; ++i) {
    const bool is_of_object = i < of_objects_.size();
    const std::size_t place = is_of_object ? i : i - of_objects_.size() + 1;
    if ((is_of_object ? of_objects_ : of_world_)[place] != number) continue;
    if (meaning) return std::nullopt;
    const auto index = static_cast<std::uint16_t>(place);
    meaning = is_of_object ? Meaning{index, 0} : Meaning{0, index};
  }
  return meaning;
}

}  // namespace synthetic_dataset

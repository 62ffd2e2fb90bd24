#include "plugins/nuscenes/nuscenes_categories.h"

#include <map>

namespace synthetic_dataset::nuscenes {

PointCategories::PointCategories(const DatasetInfo& dataset) {
  std::map<std::string, std::size_t> numbers;
  for (const ClassInfo& each : dataset.classes) numbers.emplace(each.name, numbers.size() + 1);
  for (const std::string& name : dataset.world_classes) {
    of_world_.push_back(numbers.emplace(name, numbers.size() + 1).first->second);
  }
}

std::uint8_t PointCategories::of(const CloudPoint& point) const {
  if (point.class_number > 0) return static_cast<std::uint8_t>(point.class_number);
  if (point.world_class == 0) return 0;
  return static_cast<std::uint8_t>(of_world_.at(point.world_class - std::size_t{1}));
}

std::string lidarsegFile(const std::string& version, const std::string& data_token) {
  return "lidarseg/" + version + "/" + data_token + "_lidarseg.bin";
}

}  // namespace synthetic_dataset::nuscenes

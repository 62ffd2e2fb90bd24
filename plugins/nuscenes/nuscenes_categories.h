#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::nuscenes {

/// The category numbers of lidarseg's points: 0 is noise, followed by the classes of objects and
/// those of the world; classes with the same name share a number.
class PointCategories {
 public:
  explicit PointCategories(const DatasetInfo& dataset);

  [[nodiscard]] std::uint8_t of(const CloudPoint& point) const;

  /// The number of a class of the world. @param index  in DatasetInfo::world_classes
  [[nodiscard]] std::size_t ofWorld(std::size_t index) const { return of_world_[index]; }

 private:
  std::vector<std::size_t> of_world_;
};

/// The file with the categories of a lidar's points.
[[nodiscard]] std::string lidarsegFile(const std::string& version, const std::string& data_token);

}  // namespace synthetic_dataset::nuscenes

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::nuscenes {

/// The numbers of categories that lidarseg's points have: 0 is noise, then come the classes of
/// objects and those of the world, one number for both where they have the same name.
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

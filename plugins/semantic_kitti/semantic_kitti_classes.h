#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "synthetic_dataset/cloud.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// The numbers in SemanticKITTI's labels for the classes of objects and of the world.
class SemanticKittiClasses {
 public:
  SemanticKittiClasses() = default;

  /// Reads `class_ids`: class to number, 1 to 65535. Classes not named there get the lowest unused
  /// numbers, those of objects before those of the world.
  SemanticKittiClasses(Parameters& parameters, const DatasetInfo& dataset);

  /// The number of a point's class; 0 if it has none.
  [[nodiscard]] std::uint32_t numberOf(const CloudPoint& point) const;

  /// The class that a number stands for: CloudPoint's `class_number` and `world_class`. Nothing if
  /// several classes share it.
  struct Meaning {
    std::uint16_t class_number = 0;
    std::uint16_t world_class = 0;
  };
  [[nodiscard]] std::optional<Meaning> meaningOf(std::uint32_t number) const;

  /// All names by number, "unlabeled" for 0.
  [[nodiscard]] const std::map<std::uint32_t, std::string>& names() const { return names_; }

 private:
  std::vector<std::uint32_t> of_objects_;  ///< by CloudPoint::class_number
  std::vector<std::uint32_t> of_world_;    ///< by CloudPoint::world_class
  std::map<std::uint32_t, std::string> names_;
};

}  // namespace synthetic_dataset

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "synthetic_dataset/cloud.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// The numbers that SemanticKITTI's labels have for classes of objects and of the world.
class SemanticKittiClasses {
 public:
  SemanticKittiClasses() = default;

  /// Reads `class_ids`: class to number, 1 to 65535. Classes that it does not name get the least
  /// numbers that are left, those of objects before those of the world.
  SemanticKittiClasses(Parameters& parameters, const DatasetInfo& dataset);

  /// 0 for what is of no class.
  [[nodiscard]] std::uint32_t numberOf(const CloudPoint& point) const;

  /// Which class a number is: CloudPoint's `class_number` and `world_class`. Nothing where several
  /// classes have it.
  struct Meaning {
    std::uint16_t class_number = 0;
    std::uint16_t world_class = 0;
  };
  [[nodiscard]] std::optional<Meaning> meaningOf(std::uint32_t number) const;

  /// All names by their numbers, "unlabeled" for 0.
  [[nodiscard]] const std::map<std::uint32_t, std::string>& names() const { return names_; }

 private:
  std::vector<std::uint32_t> of_objects_;  ///< by CloudPoint::class_number
  std::vector<std::uint32_t> of_world_;    ///< by CloudPoint::world_class
  std::map<std::uint32_t, std::string> names_;
};

}  // namespace synthetic_dataset

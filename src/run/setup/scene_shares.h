#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace synthetic_dataset::run {

/// A motion that shares a run's scenes with others.
struct SharingMotion {
  std::string group;           ///< its parameters, for messages: "motions/0"
  double weight = 1.0;         ///< > 0
  std::int64_t available = 0;  ///< scenes that it has
};

/// How many scenes each motion gives, in proportion to their weights as near as whole numbers
/// come (largest remainder method).
/// @param total  of all of them; nothing: the most for which every motion has enough
/// @throws ErrorList when a motion has too few, or would give none
[[nodiscard]] std::vector<std::int64_t> sharesOf(const std::vector<SharingMotion>& motions,
                                                 std::optional<std::int64_t> total);

}  // namespace synthetic_dataset::run

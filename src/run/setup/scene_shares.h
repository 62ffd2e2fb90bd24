#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace synthetic_dataset::run {

/// A motion that shares a run's scenes with others.
struct SharingMotion {
  std::string group;           ///< its parameter group, for messages: "motions/0"
  double weight = 1.0;         ///< > 0
  std::int64_t available = 0;  ///< number of scenes it has
};

/// How many scenes each motion contributes: in proportion to the weights, as closely as whole
/// numbers allow (largest remainder method).
/// @param total  of all motions; nothing: the largest total for which every motion has enough
///     scenes
/// @throws ErrorList if a motion has too few, or would contribute none
[[nodiscard]] std::vector<std::int64_t> sharesOf(const std::vector<SharingMotion>& motions,
                                                 std::optional<std::int64_t> total);

}  // namespace synthetic_dataset::run

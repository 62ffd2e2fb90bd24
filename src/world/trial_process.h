#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace synthetic_dataset::world {

struct TrialLimits {
  std::chrono::seconds processor_time{120};
  std::uint64_t memory = std::uint64_t{4} << 30U;  ///< [byte], beyond what is in use already
};

/// Does a piece of work in a process of its own, so that a library that crashes or never ends takes
/// nothing else with it. What the work changes or prints is lost.
/// @param work  as a rule what is done again here when it has gone well; may throw
/// @return how it broke down ("crashes (Segmentation fault)"), or nothing when it came to an end
[[nodiscard]] std::optional<std::string> breakdownOf(const std::function<void()>& work,
                                                     const TrialLimits& limits);

}  // namespace synthetic_dataset::world

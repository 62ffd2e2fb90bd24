#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <variant>

namespace synthetic_dataset::world {

struct TrialLimits {
  std::chrono::seconds processor_time{120};
  std::uint64_t memory = std::uint64_t{4} << 30U;  ///< [byte], beyond what is in use already
};

/// How a piece of work broke down: "crashes (Segmentation fault)".
struct Breakdown {
  std::string how;
};

/// Does a piece of work in a process of its own, so that a library that crashes or never ends takes
/// nothing else with it. What the work changes or prints is lost; what it returns is handed over.
/// Where no process is to be had the work is done in this one.
/// @param work  may throw Error
/// @return the work's result, or how it broke down
/// @throws Error as the work does
[[nodiscard]] std::variant<std::string, Breakdown> tryWork(const std::function<std::string()>& work,
                                                           const TrialLimits& limits);

}  // namespace synthetic_dataset::world

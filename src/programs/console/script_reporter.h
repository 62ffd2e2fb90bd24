#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "programs/console/console_reporter.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// A run's progress, for programs: `scenes_done`, `scenes`, `rate` [Hz], `time_left` [s] and
/// `warnings`.
/// @param seconds  since its first scene was begun
[[nodiscard]] Value progressValue(std::int64_t scenes_done, std::int64_t scenes, double seconds,
                                  std::int64_t warnings);

/// Reports to the console and, five times a second, prints the run's progress as a line of JSON on
/// the standard output.
class ScriptReporter : public ConsoleReporter {
 public:
  void warning(const std::string& message) override;
  void progress(std::int64_t scenes_done, std::int64_t scenes) override;

 private:
  using Clock = std::chrono::steady_clock;

  std::optional<Clock::time_point> start_;
  Clock::time_point printed_;
  std::int64_t warnings_ = 0;
};

}  // namespace synthetic_dataset::programs

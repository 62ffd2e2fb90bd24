#include "programs/console/script_reporter.h"

#include <iostream>

#include "base/json_text.h"

namespace synthetic_dataset::programs {

Value progressValue(std::int64_t scenes_done, std::int64_t scenes, double seconds,
                    std::int64_t warnings) {
  const double rate = seconds > 0.0 ? static_cast<double>(scenes_done) / seconds : 0.0;
  const double left = rate > 0.0 ? static_cast<double>(scenes - scenes_done) / rate : 0.0;
  return Value::Map{{"scenes_done", Value(scenes_done)},
                    {"scenes", Value(scenes)},
                    {"rate", Value(rate)},
                    {"time_left", Value(left)},
                    {"warnings", Value(warnings)}};
}

void ScriptReporter::warning(const std::string& message) {
  ConsoleReporter::warning(message);
  ++warnings_;
}

void ScriptReporter::progress(std::int64_t scenes_done, std::int64_t scenes) {
  constexpr std::chrono::milliseconds kPeriod(200);
  ConsoleReporter::progress(scenes_done, scenes);
  const auto now = Clock::now();
  const bool is_first = !start_;
  if (is_first) start_ = now;
  if (!is_first && scenes_done != scenes && now - printed_ < kPeriod) return;
  printed_ = now;
  const double seconds = std::chrono::duration<double>(now - *start_).count();
  std::cout << base::jsonText(progressValue(scenes_done, scenes, seconds, warnings_)) << std::endl;
}

}  // namespace synthetic_dataset::programs

#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

namespace synthetic_dataset::programs {

/// The output of `generate --json` so far.
class RunLog {
 public:
  /// Takes a line: progress, the result, or a message for people.
  void take(const std::string& line);

  std::int64_t scenes_done = 0;
  std::int64_t scenes = 0;
  double rate = 0.0;       ///< [Hz]
  double time_left = 0.0;  ///< [s]
  std::string result;      ///< "done", "stopped" or "failed"; empty: the run has not ended
  std::vector<std::string> errors;
  std::deque<std::string> lines;  ///< for people, the last ones
};

/// A line without a terminal's colour codes.
[[nodiscard]] std::string withoutColours(const std::string& line);

}  // namespace synthetic_dataset::programs

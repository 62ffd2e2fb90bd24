#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace synthetic_dataset::output {

/// Reports how far a run is: percent, scenes per second, time left.
class Progress {
 public:
  /// A monotonic clock [s].
  using Clock = std::function<double()>;

  /// Receives text as it is to appear: no newline, except after the last text on a terminal.
  using Sink = std::function<void(const std::string& text)>;

  enum class Display {
    kTerminal,  ///< one line that rewrites itself: each text begins with `\r`
    kLog,       ///< a message from time to time
  };

  /// Reads the clock for the first time.
  /// @param scene_count  the total number of scenes
  Progress(std::int64_t scene_count, Display display, Clock clock, Sink sink);

  /// Shows the progress after the first scene, after the last one, and at intervals in between.
  void sceneDone();

 private:
  [[nodiscard]] std::string text(double now) const;

  std::int64_t scene_count_;
  Display display_;
  Clock clock_;
  Sink sink_;
  double start_;
  double last_shown_ = 0.0;
  std::size_t last_width_ = 0;
  std::int64_t done_ = 0;
};

}  // namespace synthetic_dataset::output

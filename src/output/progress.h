#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace synthetic_dataset::output {

/// Reports how far a run is: percent, scenes per second, time left.
class Progress {
 public:
  /// A clock that never goes back [s].
  using Clock = std::function<double()>;

  /// Takes pieces of text as they are to appear, without a newline but at a terminal's last line.
  using Sink = std::function<void(const std::string& text)>;

  enum class Display {
    kTerminal,  ///< one line that rewrites itself: each text begins with `\r`
    kLog,       ///< a message now and then
  };

  /// The clock is read here for the first time.
  /// @param scene_count  how many scenes there will be
  Progress(std::int64_t scene_count, Display display, Clock clock, Sink sink);

  /// Shows the progress after the first scene, after the last one, and in between not too often.
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

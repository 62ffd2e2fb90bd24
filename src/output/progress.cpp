#include "output/progress.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::output {
namespace {

constexpr double kLogPeriod = 5.0;       // [s]
constexpr double kTerminalPeriod = 0.2;  // [s]

/// "m:ss" or "h:mm:ss"
std::string clockText(double duration) {
  const long long seconds = std::llround(duration);
  const long long hours = seconds / 3600;
  const long long minutes = seconds / 60 % 60;
  std::array<char, 40> text{};
  if (hours > 0) {
    std::snprintf(text.data(), text.size(), "%lld:%02lld:%02lld", hours, minutes, seconds % 60);
  } else {
    std::snprintf(text.data(), text.size(), "%lld:%02lld", minutes, seconds % 60);
  }
  return text.data();
}

}  // namespace

Progress::Progress(std::int64_t scene_count, Display display, Clock clock, Sink sink)
    : scene_count_(scene_count),
      display_(display),
      clock_(std::move(clock)),
      sink_(std::move(sink)),
      start_(clock_()) {}

void Progress::sceneDone() {
  ++done_;
  const double now = clock_();
  const bool last = done_ == scene_count_;
  const double period = display_ == Display::kTerminal ? kTerminalPeriod : kLogPeriod;
  if (done_ != 1 && !last && now - last_shown_ < period) return;
  last_shown_ = now;
  std::string shown = text(now);
  if (display_ == Display::kTerminal) {
    const std::size_t width = shown.size();
    shown.resize(std::max(width, last_width_), ' ');  // overwrites the rest of the previous text
    last_width_ = width;
    shown = "\r" + shown + (last ? "\n" : "");
  }
  sink_(shown);
}

std::string Progress::text(double now) const {
  const std::int64_t count = std::max(scene_count_, done_);
  std::string text = "scene " + std::to_string(done_) + " of " + std::to_string(count) + " (" +
                     std::to_string(100 * done_ / count) + " %)";
  const double elapsed = now - start_;
  if (elapsed <= 0.0) return text;
  const auto done = static_cast<double>(done_);
  text += ", " + fixed(done / elapsed, 1) + " scenes/s";
  if (done_ == count) return text;
  return text + ", " + clockText(static_cast<double>(count - done_) * elapsed / done) + " left";
}

}  // namespace synthetic_dataset::output

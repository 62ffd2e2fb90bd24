#include "programs/console/console_reporter.h"

#include <unistd.h>

#include <chrono>
#include <iostream>
#include <utility>

#include <ros/console.h>

#include "base/printable_text.h"
#include "programs/console/stop_signals.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::programs {
namespace {

constexpr double kPatience = 2.0;  ///< [s] before users wonder what is going on

double secondsNow() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

}  // namespace

StartReport::StartReport(Clock clock, Sink sink)
    : clock_(std::move(clock)),
      sink_(std::move(sink)),
      start_(clock_()),
      next_(start_ + kPatience) {}

void StartReport::begin(const std::string& stage) {
  const std::lock_guard<std::mutex> lock(mutex_);
  stage_ = stage;
}

void StartReport::look() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const double now = clock_();
  if (now < next_ || stage_.empty() || !reported_.insert(stage_).second) return;
  next_ = now + kPatience;
  sink_("still starting after " + fixed(now - start_, 0) + " s: " + stage_);
}

void ConsoleReporter::info(const std::string& message) {
  ROS_INFO_STREAM(base::printable(message));
}

void ConsoleReporter::warning(const std::string& message) {
  ROS_WARN_STREAM(base::printable(message));
}

void ConsoleReporter::fatal(const std::string& message) {
  ROS_FATAL_STREAM(base::printable(message));
}

void ConsoleReporter::stage(const std::string& what) {
  if (is_started_) return;
  if (!start_report_) {
    start_report_ = std::make_unique<StartReport>(
        secondsNow, [](const std::string& message) { ROS_INFO_STREAM(base::printable(message)); });
    ticker_ = std::make_unique<Ticker>([this] { start_report_->look(); });
  }
  start_report_->begin(what);
}

void ConsoleReporter::progress(std::int64_t /*scenes_done*/, std::int64_t scenes) {
  if (progress_ == nullptr) {
    start(scenes);
  } else {
    is_started_ = true;
    ticker_.reset();
    progress_->sceneDone();
  }
}

bool ConsoleReporter::stopRequested() const { return stop_signals::requested() != 0; }

void ConsoleReporter::start(std::int64_t scenes) {
  stop_signals::stopAfterScene();
  const bool terminal = isatty(STDOUT_FILENO) == 1;
  const auto sink = [terminal](const std::string& text) {
    if (terminal) {
      std::cout << text << std::flush;
    } else {
      ROS_INFO_STREAM(text);
    }
  };
  progress_ = std::make_unique<output::Progress>(
      scenes, terminal ? output::Progress::Display::kTerminal : output::Progress::Display::kLog,
      secondsNow, sink);
}

}  // namespace synthetic_dataset::programs

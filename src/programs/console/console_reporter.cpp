#include "programs/console/console_reporter.h"

#include <chrono>
#include <iostream>

#include <ros/console.h>
#include <unistd.h>

#include "base/printable_text.h"
#include "programs/console/stop_signals.h"

namespace synthetic_dataset::programs {
namespace {

double secondsNow() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

}  // namespace

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
        secondsNow, [](const std::string& message) { ROS_INFO_STREAM(message); });
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
  stop_signals::waitForScenes();
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

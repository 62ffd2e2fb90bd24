/// The node `generate`: ROS parameters in, a dataset out, the result as exit code.

#include <chrono>
#include <csignal>
#include <iostream>
#include <memory>
#include <string>

#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <unistd.h>

#include "generator.h"
#include "output/progress.h"
#include "ros_parameters.h"
#include "synthetic_dataset/errors.h"

namespace {

using namespace synthetic_dataset;

constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kInterrupted = 128;  // plus the signal's number, as shells have it

volatile std::sig_atomic_t g_signal = 0;  // the only way from a signal handler to the loop

void onSignal(int signal) { g_signal = signal; }

double secondsNow() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

/// Tells the run's events to rosconsole, and its progress to a terminal if there is one.
class RosReporter : public Reporter {
 public:
  void info(const std::string& message) override { ROS_INFO_STREAM(message); }
  void warning(const std::string& message) override { ROS_WARN_STREAM(message); }

  void progress(std::int64_t scenes_done, std::int64_t scenes) override {
    if (scenes_done == 0) {
      start(scenes);
    } else {
      progress_->sceneDone();
    }
  }

  [[nodiscard]] bool stopRequested() const override { return g_signal != 0; }

 private:
  void start(std::int64_t scenes) {
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

  std::unique_ptr<output::Progress> progress_;
};

int generate() {
  RosReporter reporter;
  Generator generator(readRosParameters(), reporter);
  const RunSummary summary = generator.run();
  for (const std::string& line : summaryLines(summary)) ROS_INFO_STREAM(line);
  if (summary.stopped) {
    ROS_WARN_STREAM("stopped: the scenes made so far are whole, but the dataset is not complete");
    return kInterrupted + g_signal;
  }
  ROS_INFO_STREAM("done");
  return kDone;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    ros::init(argc, argv, "generate", ros::init_options::NoSigintHandler);
  } catch (const std::exception& error) {  // no folder for logs, for one
    std::cerr << "generate: ROS cannot start: " << error.what() << '\n';
    return kFailed;
  }
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  if (!ros::master::check()) {
    std::cerr << "generate: no ROS master answers at ROS_MASTER_URI; start roscore, or use "
                 "`roslaunch synthetic_dataset generate.launch config:=FILE`\n";
    return kFailed;
  }
  try {
    return generate();
  } catch (const ErrorList& errors) {
    for (const std::string& message : errors.messages()) ROS_FATAL_STREAM(message);
    const std::size_t count = errors.messages().size();
    ROS_FATAL_STREAM("failed: " << count << (count == 1 ? " error" : " errors"));
  } catch (const std::exception& error) {
    ROS_FATAL_STREAM(error.what());
    ROS_FATAL_STREAM("failed: 1 error");
  }
  return kFailed;
}

/// The program `generate`: settings from a file or from ROS parameters in, a dataset out, the
/// result as exit code.

#include <cstdio>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <ros/init.h>
#include <ros/master.h>
#include <ros/node_handle.h>

#include "config/settings_file.h"
#include "programs/console/command_line.h"
#include "programs/console/console_reporter.h"
#include "programs/console/heap.h"
#include "programs/console/live_map.h"
#include "programs/console/parallel_run.h"
#include "programs/console/ros_parameters.h"
#include "programs/console/stop_signals.h"
#include "run/generator.h"
#include "run/setup/ros_packages.h"
#include "synthetic_dataset/errors.h"

namespace {

using namespace synthetic_dataset;

constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kInterrupted = 128;  // plus the signal's number, as shells have it

/// Neither master nor ROS's log folder is needed: rosconsole alone works without ros::init.
Value settingsWithoutMaster(const programs::CommandLine& command_line) {
  Value::Map settings = config::loadSettings(*command_line.config, run::rosPackageFinder());
  for (const auto& [name, text] : command_line.settings) {
    config::overlay(settings, config::settingOf(name, text));
  }
  return settings;
}

/// Whether this is a node now, with a parameter server to ask; says why not.
bool startNode(int argc, char** argv) {
  try {
    ros::init(argc, argv, "generate", ros::init_options::NoSigintHandler);
  } catch (const std::exception& error) {  // no folder for logs, for one
    std::cerr << "generate: ROS cannot start: " << error.what() << '\n';
    return false;
  }
  if (ros::master::check()) return true;
  std::cerr << "generate: no ROS master answers at ROS_MASTER_URI; use `generate --config FILE`, "
               "which needs none, or `roslaunch synthetic_dataset generate.launch config:=FILE`\n";
  return false;
}

int stopped(run::Reporter& reporter) {
  const int signal = stop_signals::requested();
  reporter.warning(std::string("stopped by ") + stop_signals::name(signal) +
                   ": the scenes made so far are whole; run the same command again to go on "
                   "(`if_exists: overwrite` starts anew)");
  return kInterrupted + signal;
}

int generateHere(const Value& settings, run::Reporter& reporter) {
  run::Generator generator(settings, reporter);
  const run::RunSummary summary = generator.run();
  for (const std::string& line : run::summaryLines(summary)) reporter.info(line);
  if (summary.stopped) return stopped(reporter);
  reporter.info(run::lastLine(summary));
  return kDone;
}

int generate(const Value& settings) {
  programs::ConsoleReporter reporter;
  const programs::ParallelRun run(settings);
  if (!run.isPossible()) return generateHere(settings, reporter);
  const auto summary = run.make(reporter);
  if (!summary) return stopped(reporter);
  reporter.info(run::lastLine(*summary));
  return kDone;
}

/// Makes the dataset of the settings that `read_settings` finds; reports what is wrong with them.
template <class ReadSettings>
int generateOrReport(ReadSettings read_settings) {
  try {
    return generate(read_settings());
  } catch (const ErrorList& errors) {
    for (const std::string& message : errors.messages()) programs::ConsoleReporter::fatal(message);
    const std::size_t count = errors.messages().size();
    programs::ConsoleReporter::fatal("failed: " + std::to_string(count) +
                                     (count == 1 ? " error" : " errors"));
  } catch (const std::exception& error) {
    programs::ConsoleReporter::fatal(error.what());
    programs::ConsoleReporter::fatal("failed: 1 error");
  }
  return kFailed;
}

}  // namespace

int main(int argc, char** argv) {
  heap::prepare();
  programs::CommandLine command_line;
  try {
    command_line = programs::parseCommandLine({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cerr << "generate: " << error.what() << '\n' << programs::usage();
    return kFailed;
  }
  if (command_line.wants_help) {
    std::cout << programs::usage();
    return kDone;
  }
  // Messages appear when they are made, also in files: a program that is stopped at once loses
  // none.
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  stop_signals::install();
  if (command_line.config) {
    return generateOrReport([&] { return settingsWithoutMaster(command_line); });
  }
  if (!startNode(argc, argv)) return kFailed;
  std::optional<ros::NodeHandle> node;  // to the end: without it, rosconsole prints nothing
  return generateOrReport([&] {
    Value settings = programs::readRosParameters(run::rosPackageFinder());
    if (programs::wantsLiveMap(settings)) {
      programs::ConsoleReporter reporter;
      programs::takeLiveMap(settings, node.emplace(), reporter);
    }
    return settings;
  });
}

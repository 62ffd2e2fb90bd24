/// The program `generate`: settings from a file or from ROS parameters in, a dataset out, the
/// result as exit code.

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <ros/init.h>
#include <ros/master.h>
#include <ros/node_handle.h>

#include "base/json_text.h"
#include "base/printable_text.h"
#include "config/twin_runs.h"
#include "programs/check/check_report.h"
#include "programs/console/command_line.h"
#include "programs/console/console_reporter.h"
#include "programs/console/heap.h"
#include "programs/console/parallel_run.h"
#include "programs/console/processes.h"
#include "programs/console/ros_parameters.h"
#include "programs/console/run_topics.h"
#include "programs/console/script_reporter.h"
#include "programs/console/stop_signals.h"
#include "programs/console/topic_map.h"
#include "programs/settings/documented_settings.h"
#include "programs/settings/settings_print.h"
#include "run/generator.h"
#include "run/setup/package_index.h"
#include "run/setup/run_setup.h"
#include "synthetic_dataset/errors.h"

namespace {

using namespace synthetic_dataset;

constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kOdd = 3;            // of --check
constexpr int kInterrupted = 128;  // plus the signal's number, as in shells

/// Starts the ROS node. Returns whether there is a parameter server to ask; if not, prints why.
bool startNode(int argc, char** argv) {
  try {
    ros::init(argc, argv, "generate", ros::init_options::NoSigintHandler);
  } catch (const std::exception& error) {  // for example, no folder for logs
    std::cerr << "generate: ROS cannot start: " << base::printable(error.what()) << '\n';
    return false;
  }
  if (ros::master::check()) return true;
  std::cerr << "generate: no ROS master answers at ROS_MASTER_URI; use `generate --config FILE`, "
               "which needs none, or `roslaunch synthetic_dataset generate.launch config:=FILE`\n";
  return false;
}

/// All settings, for people or for editors.
std::string settingsText(bool as_json) {
  if (!as_json) return programs::settingsDocument();
  return base::jsonText(programs::settingsSchema()) + "\n";
}

/// Prints the settings of a file with its short forms expanded.
int printSpelledOut(const Value& settings, bool as_json) {
  const Value spelled = run::spelledOut(settings);
  std::cout << (as_json ? base::jsonText(spelled) + "\n" : programs::settingsYaml(spelled));
  return kDone;
}

/// Tells scripts how a run ended, in the last line on stdout.
void printEnd(const programs::CommandLine& command_line, const std::string& result,
              Value::Map value) {
  if (!command_line.as_json) return;
  value["result"] = Value(result);
  std::cout << base::jsonText(Value(value)) << std::endl;
}

void printErrors(const programs::CommandLine& command_line,
                 const std::vector<std::string>& errors) {
  Value::List texts;
  for (const std::string& each : errors) {
    programs::ConsoleReporter::fatal(each);
    texts.emplace_back(each);
  }
  programs::ConsoleReporter::fatal("failed: " + std::to_string(errors.size()) +
                                   (errors.size() == 1 ? " error" : " errors"));
  printEnd(command_line, "failed", {{"errors", Value(texts)}});
}

/// How a run ended.
struct Ended {
  bool was_stopped = false;
  Value::Map summary;
};

int reportEnd(const Ended& ended, const programs::CommandLine& command_line,
              run::Reporter& reporter) {
  if (!ended.was_stopped) {
    printEnd(command_line, "done", ended.summary);
    return kDone;
  }
  const int signal = programs::stop_signals::requested();
  reporter.warning(std::string("stopped by ") + programs::stop_signals::name(signal) +
                   ": the scenes made so far are whole; run the same command again to go on "
                   "(`if_exists: overwrite` starts anew)");
  printEnd(command_line, "stopped", ended.summary);
  return kInterrupted + signal;
}

Ended generateHere(const Value& settings, run::Reporter& reporter) {
  run::Generator generator(settings, reporter);
  const run::RunSummary summary = generator.run();
  for (const std::string& line : run::summaryLines(summary)) reporter.info(line);
  if (!summary.stopped) reporter.info(run::lastLine(summary));
  return {summary.stopped, run::summaryValue(summary)};
}

/// Findings are not a failure, but scripts may want to know.
int check(const Value& settings, const programs::CommandLine& command_line) {
  const bool is_fine =
      programs::checkAndPrint(settings, programs::picturesFolder(command_line), std::cout);
  return is_fine ? kDone : kOdd;
}

Ended generateOne(const Value& settings, run::Reporter& reporter) {
  const programs::ParallelRun run(settings);
  if (!run.isPossible()) return generateHere(settings, reporter);
  const auto summary = run.make(reporter);
  if (!summary) return {true, {}};
  reporter.info(run::lastLine(*summary));
  return {false, run::summaryValue(*summary)};
}

bool anyInProcesses(const std::vector<Value>& runs) {
  return std::any_of(runs.begin(), runs.end(),
                     [](const Value& each) { return programs::ParallelRun(each).isPossible(); });
}

/// If one of several runs forks, each is made in a process of its own: a run that draws has
/// threads, and a process that is forked while there are other threads may wait for ever.
int generateEachApart(const std::vector<Value>& runs, const programs::CommandLine& command_line,
                      run::Reporter& reporter) {
  const auto work = [&](int run, run::Reporter& of_run) {
    const Ended ended = generateOne(runs[static_cast<std::size_t>(run)], of_run);
    if (!ended.was_stopped) printEnd(command_line, "done", ended.summary);
    return !ended.was_stopped;
  };
  if (programs::doInTurn(static_cast<int>(runs.size()), work, reporter)) return kDone;
  return reportEnd({true, {}}, command_line, reporter);
}

int generate(const Value& settings, const programs::CommandLine& command_line,
             run::Reporter& reporter) {
  if (command_line.wants_settings) return printSpelledOut(settings, command_line.as_json);
  const std::vector<Value> runs = config::twinRuns(settings);
  if (command_line.wants_check) return check(runs.front(), command_line);
  if (runs.size() > 1 && anyInProcesses(runs)) {
    return generateEachApart(runs, command_line, reporter);
  }
  for (const Value& each : runs) {
    const int code = reportEnd(generateOne(each, reporter), command_line, reporter);
    if (code != kDone) return code;
  }
  return kDone;
}

/// Makes the dataset of the settings that `read_settings` returns; reports what is wrong with them.
template <class ReadSettings>
int generateOrReport(const programs::CommandLine& command_line, run::Reporter& reporter,
                     ReadSettings read_settings) {
  try {
    return generate(read_settings(), command_line, reporter);
  } catch (const ErrorList& errors) {
    printErrors(command_line, errors.messages());
  } catch (const std::exception& error) {
    printErrors(command_line, {error.what()});
  }
  return kFailed;
}

}  // namespace

int main(int argc, char** argv) {
  programs::heap::prepare();
  base::printUtf8();
  programs::CommandLine command_line;
  try {
    command_line = programs::parseCommandLine({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cerr << "generate: " << base::printable(error.what()) << '\n' << programs::usage();
    return kFailed;
  }
  if (command_line.wants_help) {
    std::cout << programs::usage();
    return kDone;
  }
  if (command_line.wants_settings && !command_line.config) {
    std::cout << settingsText(command_line.as_json);
    return kDone;
  }
  // Flushes each line, also into files, so that no message is lost if the program is killed.
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  programs::stop_signals::install();
  if (command_line.config) {
    programs::ConsoleReporter for_people;
    programs::ScriptReporter for_scripts;
    run::Reporter& reporter = command_line.as_json ? for_scripts : for_people;
    return generateOrReport(command_line, reporter, [&] {
      return programs::settingsOf(command_line,
                                  [&](const std::string& text) { reporter.warning(text); });
    });
  }
  if (!startNode(argc, argv)) return kFailed;
  std::optional<ros::NodeHandle> node;  // kept to the end: without it, rosconsole prints nothing
  programs::RunTopics reporter(node);
  return generateOrReport(command_line, reporter, [&] {
    Value settings = programs::readRosParameters(run::rosPackageFinder());
    if (programs::wantsTopicMap(settings)) {
      programs::takeTopicMap(settings, node.emplace(), reporter);
    }
    return settings;
  });
}

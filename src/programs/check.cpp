/// The tool `check`: examines the run of a settings file before it is made.
///
///   rosrun synthetic_dataset check FILE [NAME:=VALUE ...] [--out DIR]
///
/// Exit code 0 if nothing is odd, 3 if something is, 1 if the run is not possible.

#include <exception>
#include <iostream>

#include "base/printable_text.h"
#include "config/twin_runs.h"
#include "programs/check/check_report.h"
#include "programs/console/command_line.h"
#include "programs/console/heap.h"

int main(int argc, char** argv) {
  using namespace synthetic_dataset;
  constexpr int kOdd = 3;
  programs::heap::prepare();
  programs::CommandLine line;
  try {
    line = programs::parseCheckLine({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cerr << "check: " << base::printable(error.what()) << '\n' << programs::checkUsage();
    return 1;
  }
  if (line.wants_help) {
    std::cout << programs::checkUsage();
    return 0;
  }
  return programs::reportingErrors("check", [&] {
    const Value settings = programs::settingsOf(line, [](const std::string& text) {
      std::cerr << "check: " << base::printable(text) << '\n';
    });
    return programs::checkAndPrint(config::twinRuns(settings).front(),
                                   programs::picturesFolder(line), std::cout)
               ? 0
               : kOdd;
  });
}

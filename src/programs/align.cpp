/// The tool `align`: finds how a camera's clock and frame differ from those of TF.
///
///   rosrun synthetic_dataset align [--focal-length] FILE [NAME:=VALUE ...]
///
/// Exit code 0 with settings on the standard output, 3 if the recording does not determine them, 1
/// for a failure.

#include <algorithm>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "base/printable_text.h"
#include "programs/align/align_report.h"
#include "programs/console/command_line.h"
#include "programs/console/console_reporter.h"
#include "programs/console/heap.h"
#include "run/align/aligner.h"
#include "synthetic_dataset/errors.h"

namespace {

constexpr const char* kUsage = R"(usage: align [--focal-length] FILE [NAME:=VALUE ...]

Finds how a camera's clock and frame differ from those of TF, from 60 of its recorded
pictures. FILE has the settings of a run with `camera/image_topic` (docs/twin.md). Prints
the settings camera/time_offset and camera/correction, with their standard deviations.

  --focal-length  finds camera/focal_scale as well: by how much the calibration's focal
                  length is wrong
  --help          prints this

  align settings.yaml > aligned.yaml

Exit codes: 0 settings found, 3 the recording does not determine them, 1 failed.
)";

}  // namespace

int main(int argc, char** argv) {
  using namespace synthetic_dataset;
  constexpr int kDoesNotTell = 3;
  programs::heap::prepare();
  programs::CommandLine line;
  run::AlignOptions options;
  try {
    std::vector<std::string> arguments(argv + 1, argv + argc);
    const auto rest = std::remove(arguments.begin(), arguments.end(), "--focal-length");
    options.focal_length = rest != arguments.end();
    arguments.erase(rest, arguments.end());
    line = programs::parseCheckLine(arguments);
    if (line.out) throw Error("found --out; align writes no files");
  } catch (const std::exception& error) {
    std::cerr << "align: " << base::printable(error.what()) << '\n' << kUsage;
    return 1;
  }
  if (line.wants_help) {
    std::cout << kUsage;
    return 0;
  }
  return programs::reportingErrors("align", [&] {
    run::Reporter silent;
    const auto warn = [](const std::string& text) {
      std::cerr << "align: " << base::printable(text) << '\n';
    };
    const run::CameraAlignment found =
        run::alignCamera(programs::settingsOf(line, warn), options, silent);
    for (const std::string& text : programs::alignmentLines(found, options)) {
      std::cout << base::printable(text) << '\n';
    }
    return programs::isFound(found, options) ? 0 : kDoesNotTell;
  });
}

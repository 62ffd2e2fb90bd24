/// The program `merge`: shards of a run in, one dataset out, the result as exit code. Needs no ROS
/// master.

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "base/printable_text.h"
#include "programs/console/console_reporter.h"
#include "programs/console/stop_signals.h"
#include "run/merger.h"
#include "run/run_summary.h"
#include "synthetic_dataset/errors.h"

namespace {

using namespace synthetic_dataset;

constexpr const char* kUsage =
    R"(usage: merge OUTPUT_FOLDER [SHARD_FOLDER...]

Makes one dataset of the shards of a run. Without SHARD_FOLDER, the shards are those in
OUTPUT_FOLDER itself. After a kill, the same command continues.

  --help  prints this

  merge /data/run_7 /scratch/shard_0 /scratch/shard_1

Exit codes: 0 done (the last line says if labels are missing), 1 refused or failed.
)";

}  // namespace

int main(int argc, char** argv) {
  using programs::ConsoleReporter;
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool wants_help = std::count(arguments.begin(), arguments.end(), "--help") +
                              std::count(arguments.begin(), arguments.end(), "-h") !=
                          0;
  if (wants_help || arguments.empty() || arguments.front().rfind("--", 0) == 0) {
    (wants_help ? std::cout : std::cerr) << kUsage;
    return wants_help ? 0 : 1;
  }
  base::printUtf8();
  programs::stop_signals::ignoreFailedWriting();
  programs::ConsoleReporter reporter;
  try {
    const run::RunSummary summary =
        run::mergeShards(arguments.front(), {arguments.begin() + 1, arguments.end()}, reporter);
    reporter.info(run::lastLine(summary));
    return 0;
  } catch (const ErrorList& errors) {
    for (const std::string& message : errors.messages()) programs::ConsoleReporter::fatal(message);
  } catch (const std::exception& error) {
    programs::ConsoleReporter::fatal(error.what());
  }
  return 1;
}

/// The tool `inspect`: what there is in recordings, worlds and models.
///
///   rosrun synthetic_dataset inspect [--json] BAG... | WORLD | MODEL
///
/// Exit code 0, or 1 when a file cannot be read.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "base/json_text.h"
#include "programs/console/tool.h"
#include "programs/inspect/bag_report.h"
#include "programs/inspect/world_report.h"
#include "synthetic_dataset/errors.h"

namespace {

using namespace synthetic_dataset;

constexpr const char* kUsage =
    R"(usage: inspect [--json] BAG...
       inspect [--json] WORLD
       inspect [--json] MODEL

Prints what there is in recordings (the frames with their rates, times and gaps, and how
far each travels; topics; which frames look like robots and cameras), in a world (models,
sizes, lights, cameras) or in a model (links and joints): an SDF, URDF or xacro file, or
a folder with a model.config.

  --json  for programs; lengths in metres, times in seconds
  --help  prints this

  inspect my.bag
  inspect --json hall.world

Exit codes: 0 done, 1 a file cannot be read.
)";

bool isBag(const std::string& name) {
  const std::filesystem::path path(name);
  return path.extension() == ".bag" || path.extension() == ".db3" || path.extension() == ".mcap";
}

int inspect(const std::vector<std::string>& files, bool as_json) {
  if (std::all_of(files.begin(), files.end(), isBag)) {
    const motion::BagContents contents = motion::readContents(files);
    std::cout << (as_json ? base::jsonText(programs::bagValue(contents)) + "\n"
                          : programs::bagText(contents));
    return 0;
  }
  if (files.size() > 1) {
    throw Error(
        "found several files that are not all bags (.bag); worlds and models are inspected "
        "one by one");
  }
  const world::Description description = programs::readForInspection(files.front());
  std::cout << (as_json ? base::jsonText(programs::worldValue(description)) + "\n"
                        : programs::worldText(description));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> files(argv + 1, argv + argc);
  const auto take = [&](const char* option) {
    const auto found = std::find(files.begin(), files.end(), option);
    if (found == files.end()) return false;
    files.erase(found);
    return true;
  };
  if (take("--help") || take("-h")) {
    std::cout << kUsage;
    return 0;
  }
  const bool as_json = take("--json");
  const bool has_option = std::any_of(files.begin(), files.end(), [](const std::string& file) {
    return file.empty() || file.front() == '-';
  });
  if (files.empty() || has_option) {
    std::cerr << kUsage;
    return 1;
  }
  return programs::reportingErrors("inspect", [&] { return inspect(files, as_json); });
}

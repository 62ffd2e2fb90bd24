/// The tool `inspect`: prints the contents of recordings, worlds and models.
///
///   rosrun synthetic_dataset inspect [--json] BAG... | WORLD | MODEL
///
/// Exit code 0, or 1 when a file cannot be read.

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "base/json_text.h"
#include "base/printable_text.h"
#include "motion/bag/bag.h"
#include "programs/console/command_line.h"
#include "programs/inspect/bag_report.h"
#include "programs/inspect/server_descriptions.h"
#include "programs/inspect/world_report.h"
#include "synthetic_dataset/errors.h"

namespace {

using namespace synthetic_dataset;

constexpr const char* kUsage =
    R"(usage: inspect [--json] BAG...
       inspect [--json] WORLD
       inspect [--json] MODEL
       inspect --urdf BAG...

Prints what is in recordings, ROS 1 or ROS 2 bags (the frames with their rates, times and
gaps, and how far each travels; topics; which frames look like robots and cameras;
robot_description there and on the parameter server), in a world (models, sizes, lights,
cameras) or in a model (links and joints): an SDF, URDF or xacro file, or a folder with a
model.config.

  --json  for programs; lengths in metres, times in seconds
  --urdf  prints the robot model that a recording has on a topic robot_description
  --help  prints this

  inspect my.bag
  inspect my_ros2_bag/
  inspect --json hall.world

Exit codes: 0 done, 1 a file cannot be read.
)";

struct Options {
  bool as_json = false;
  bool urdf = false;
};

void printUrdf(const motion::BagContents& contents) {
  if (contents.descriptions.empty()) {
    throw Error("--urdf: the recording has no URDF on a topic robot_description");
  }
  std::cout << contents.descriptions.front().urdf << '\n';
  for (std::size_t i = 1; i < contents.descriptions.size(); ++i) {
    std::cerr << base::printable("inspect: printed " + contents.descriptions.front().topic + "; " +
                                 contents.descriptions[i].topic + " has another one\n");
  }
}

int inspect(const std::vector<std::string>& files, const Options& options) {
  const bool as_json = options.as_json;
  const bool are_bags = std::all_of(files.begin(), files.end(), motion::isBagPath);
  if (options.urdf && !are_bags)
    throw Error("--urdf: found a file that is not a bag (.bag, .db3, .mcap, or a folder of these)");
  if (are_bags) {
    const motion::BagContents contents = motion::readContents(files);
    if (options.urdf) {
      printUrdf(contents);
      return 0;
    }
    const auto on_server = programs::descriptionsOnServer();
    std::cout << (as_json ? base::jsonText(programs::bagValue(contents, on_server)) + "\n"
                          : base::printable(programs::bagText(contents, on_server)));
    return 0;
  }
  if (files.size() > 1) {
    throw Error(
        "found several files that are not all bags (.bag, .db3, .mcap, or a folder of these); "
        "worlds and models are inspected one by one");
  }
  const world::Description description = programs::readForInspection(files.front());
  std::cout << (as_json ? base::jsonText(programs::worldValue(description)) + "\n"
                        : base::printable(programs::worldText(description)));
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
  Options options;
  options.as_json = take("--json");
  options.urdf = take("--urdf");
  const bool has_option = std::any_of(files.begin(), files.end(), [](const std::string& file) {
    return file.empty() || file.front() == '-';
  });
  if (files.empty() || has_option) {
    std::cerr << kUsage;
    return 1;
  }
  return programs::reportingErrors("inspect", [&] { return inspect(files, options); });
}

/// The node `preview`: shows the scenes of a run on topics instead of writing them
/// (docs/preview.md).
///
///   roslaunch synthetic_dataset preview.launch config:=FILE
///
/// Its settings are those of `generate`, in the same parameters. Exit code 0 when ROS shuts down, 1
/// if it cannot start.

#include <exception>
#include <iostream>
#include <string>

#include <ros/init.h>
#include <ros/master.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include "base/printable_text.h"
#include "programs/console/heap.h"
#include "programs/console/ros_parameters.h"
#include "programs/preview/preview_node.h"
#include "run/setup/package_index.h"

namespace {

const char* const kUsage = R"(usage: preview [ROS remappings]

Shows the scenes of a run on topics: images, depth, labels, markers for RViz. A node with the
settings of `generate`, from the file that its parameter `settings_file` names.

  roslaunch synthetic_dataset preview.launch config:=my.yaml

Services: step, step_back, play, pause, reload. Exit codes: 0 ROS shut down, 1 it could not start.
)";

/// The node's own parameters are not settings of the run.
synthetic_dataset::Value readSettings() {
  using synthetic_dataset::Value;
  Value settings =
      synthetic_dataset::programs::readRosParameters(synthetic_dataset::run::rosPackageFinder());
  settings.as<Value::Map>()->erase("frame_prefix");
  return settings;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace synthetic_dataset;
  programs::heap::prepare();
  base::printUtf8();
  const std::string first = argc > 1 ? argv[1] : "";
  if (first == "--help" || first == "-h") {
    std::cout << kUsage;
    return 0;
  }
  try {
    ros::init(argc, argv, "preview");
    if (!ros::master::check()) {
      std::cerr << "preview: no ROS master answers at ROS_MASTER_URI; `roslaunch synthetic_dataset "
                   "preview.launch config:=FILE` starts one\n";
      return 1;
    }
    ros::NodeHandle node("~");
    programs::PreviewNode preview(node, readSettings);
    ros::AsyncSpinner callbacks(1);
    callbacks.start();
    preview.run();
  } catch (const std::exception& error) {
    std::cerr << "preview: " << base::printable(error.what()) << '\n';
    return 1;
  }
  return 0;
}

#include "support/writers/plugin_environment.h"

#include <cstdlib>

#include "support/source_folder.h"

namespace synthetic_dataset::test {
namespace {

const std::string kTestPackage = sourceFolder() + "/test/support/writers/plugin_package";
const std::string kExamplePackage = sourceFolder() + "/examples/box_table_writer";

}  // namespace

void preparePluginEnvironment(const std::vector<std::string>& packages) {
  std::string path = sourceFolder() + ":" + kTestPackage + ":" + kExamplePackage;
  for (const std::string& package : packages) path += ":" + package;
  setenv("ROS_PACKAGE_PATH", path.c_str(), 1);
  setenv("CMAKE_PREFIX_PATH", SYNTHETIC_DATASET_DEVEL_PREFIX, 1);
}

std::string pluginXml() { return sourceFolder() + "/plugins.xml"; }

std::string examplePluginXml() { return kExamplePackage + "/plugins.xml"; }

std::string testPluginXml() { return kTestPackage + "/plugins.xml"; }

}  // namespace synthetic_dataset::test

#include "support/writers/plugin_environment.h"

#include <cstdlib>

namespace synthetic_dataset::test {
namespace {

const std::string kSourceFolder = SYNTHETIC_DATASET_SOURCE_DIR;
const std::string kTestPackage = kSourceFolder + "/test/support/writers/plugin_package";

}  // namespace

void preparePluginEnvironment(const std::vector<std::string>& packages) {
  std::string path = kSourceFolder + ":" + kTestPackage;
  for (const std::string& package : packages) path += ":" + package;
  setenv("ROS_PACKAGE_PATH", path.c_str(), 1);
  setenv("CMAKE_PREFIX_PATH", SYNTHETIC_DATASET_DEVEL_PREFIX, 1);
}

std::string sourceFolder() { return kSourceFolder; }

std::string pluginXml() { return kSourceFolder + "/plugins.xml"; }

std::string testPluginXml() { return kTestPackage + "/plugins.xml"; }

}  // namespace synthetic_dataset::test

#include "output/writers/package_path.h"

#include <stdlib.h>

#include <filesystem>
#include <sstream>
#include <vector>

#include "base/ros_packages.h"

namespace synthetic_dataset::output {

std::string soundPackagePath(const std::string& package_path) {
  const bool all_sound = base::findRosPackages(package_path).broken.empty();
  std::string result;
  const auto add = [&](const std::string& entry) { result += (result.empty() ? "" : ":") + entry; };
  std::istringstream entries(package_path);
  for (std::string entry; std::getline(entries, entry, ':');) {
    const base::RosPackages inside = all_sound ? base::RosPackages() : base::findRosPackages(entry);
    const std::vector<std::filesystem::path> installed = base::installedPackages(entry);
    if (!inside.broken.empty()) {
      for (const base::RosPackage& package : inside.sound) add(package.folder.string());
    } else if (!installed.empty()) {
      for (const std::filesystem::path& package : installed) add(package.string());
    } else {
      add(entry);
    }
  }
  return result;
}

void shortenPackageSearch() {
  const char* path = getenv("ROS_PACKAGE_PATH");
  if (path != nullptr) setenv("ROS_PACKAGE_PATH", soundPackagePath(path).c_str(), 1);
}

}  // namespace synthetic_dataset::output

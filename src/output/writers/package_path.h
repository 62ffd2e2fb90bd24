#pragma once

#include <string>

namespace synthetic_dataset::output {

/// A ROS_PACKAGE_PATH with the packages of install spaces one by one, in place of the `share`
/// folders that hold them: catkin installs every package to share/<package>. rospack looks into
/// every folder below each entry, and Debian's /usr/share has thousands that are no ROS packages.
[[nodiscard]] std::string withSharedPackages(const std::string& package_path);

/// Sets ROS_PACKAGE_PATH to this for this process and those that it starts. Not while other
/// threads run.
void shortenPackageSearch();

}  // namespace synthetic_dataset::output

#pragma once

#include <string>

namespace synthetic_dataset::output {

/// A ROS_PACKAGE_PATH that rospack reads quickly, and as a whole: with the packages of install
/// spaces one by one, in place of the `share` folders that hold them, as rospack looks into every
/// folder below each entry; and without packages whose package.xml cannot be read, for one of which
/// rospack gives up all others.
[[nodiscard]] std::string soundPackagePath(const std::string& package_path);

/// Sets ROS_PACKAGE_PATH to this for this process and those that it starts. Not while other
/// threads run.
void shortenPackageSearch();

}  // namespace synthetic_dataset::output

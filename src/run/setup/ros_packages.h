#pragma once

#include "world/files/resource_finder.h"

namespace synthetic_dataset::run {

/// Finds ROS packages as ros::package::getPath does, which would print an error about each that is
/// not there, and look for every one anew.
[[nodiscard]] world::ResourceFinder::PackageFinder rosPackageFinder();

}  // namespace synthetic_dataset::run

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "world/files/resource_finder.h"

namespace synthetic_dataset::run {

/// The ROS packages of ROS_PACKAGE_PATH and AMENT_PREFIX_PATH, searched for on first use. Copies
/// share the result and may be used in different threads.
class RosPackageIndex {
 public:
  RosPackageIndex();

  /// Finds the folders of packages, as ros::package::getPath does, which however would print an
  /// error for each missing one and repeat the search for every package.
  [[nodiscard]] world::ResourceFinder::PackageFinder finder() const;

  /// Finds the paths that packages export for Gazebo.
  [[nodiscard]] world::ResourceFinder::ExportFinder exports() const;

  /// A line for each package that cannot be read; empty until someone has asked for packages.
  [[nodiscard]] std::vector<std::string> notes() const;

 private:
  struct Found;
  std::shared_ptr<Found> found_;
};

/// The finder of a temporary RosPackageIndex.
[[nodiscard]] world::ResourceFinder::PackageFinder rosPackageFinder();

}  // namespace synthetic_dataset::run

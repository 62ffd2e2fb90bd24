#pragma once

#include <memory>
#include <string>
#include <vector>

#include "world/files/resource_finder.h"

namespace synthetic_dataset::run {

/// The ROS packages of ROS_PACKAGE_PATH and AMENT_PREFIX_PATH, which are looked for when they are
/// first asked for. Copies share what was found, and threads may share copies.
class RosPackageIndex {
 public:
  RosPackageIndex();

  /// Finds the folders of packages, as ros::package::getPath does, which would print an error about
  /// each that is not there, and look for every one anew.
  [[nodiscard]] world::ResourceFinder::PackageFinder finder() const;

  /// Finds what packages export for Gazebo.
  [[nodiscard]] world::ResourceFinder::ExportFinder exports() const;

  /// A line for each package that cannot be read; none as long as nobody has asked for packages.
  [[nodiscard]] std::vector<std::string> notes() const;

 private:
  struct Found;
  std::shared_ptr<Found> found_;
};

/// RosPackageIndex::finder of an index for this once.
[[nodiscard]] world::ResourceFinder::PackageFinder rosPackageFinder();

}  // namespace synthetic_dataset::run

#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace synthetic_dataset::base {

/// A ROS package, as its package.xml (or manifest.xml) describes it.
struct RosPackage {
  std::string name;
  std::filesystem::path folder;

  /// The folders that it exports for Gazebo: `<export><gazebo_ros gazebo_model_path="..."/>`, and
  /// `gazebo_media_path`. `${prefix}` is the package's folder.
  std::vector<std::string> gazebo_models;
  std::vector<std::string> gazebo_media;
};

struct RosPackages {
  std::vector<RosPackage> sound;  ///< for each name, the first package found

  /// Folders of packages whose package.xml cannot be read, and what is wrong.
  std::vector<std::pair<std::filesystem::path, std::string>> broken;
};

/// ROS_PACKAGE_PATH, then the `share` folders of AMENT_PREFIX_PATH, where ROS 2 packages are, then
/// /usr/share, where Debian's own are: its rospack always searches there last.
[[nodiscard]] std::string rosPackagePath();

/// The folders of the packages in an entry of a ROS_PACKAGE_PATH that is the `share` folder of an
/// install space, sorted; none for other entries. catkin installs every package to
/// share/<package>, and most of the thousands of folders in Debian's /usr/share are not packages.
[[nodiscard]] std::vector<std::filesystem::path> installedPackages(
    const std::filesystem::path& entry);

/// The packages in and below the folders of a ROS_PACKAGE_PATH, in order, found as rospack finds
/// them: not within packages, folders that begin with a dot or folders with a file CATKIN_IGNORE.
/// rospack itself gives up on all packages if it cannot read one.
[[nodiscard]] RosPackages findRosPackages(const std::string& package_path);

/// "; did you mean 'x'?" for a package that ROS does not know, or "". Searches all packages.
[[nodiscard]] std::string didYouMeanPackage(const std::string& name);

}  // namespace synthetic_dataset::base

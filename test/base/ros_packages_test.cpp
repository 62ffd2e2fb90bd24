#include "base/ros_packages.h"

#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>

#include "support/temporary_folder.h"

namespace synthetic_dataset::base {
namespace ros_packages_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string package(const std::string& name, const std::string& more = "") {
  return "<package>\n<name> " + name + " </name>" + more + "</package>";
}

std::vector<std::string> namesOf(const RosPackages& packages) {
  std::vector<std::string> names;
  for (const RosPackage& each : packages.sound) names.push_back(each.name);
  return names;
}

TEST(RosPackages, AreFoundBelowThePathInItsOrder) {
  const test::TemporaryFolder folder;
  (void)folder.write("overlay/arm/package.xml", package("arm"));
  (void)folder.write("base/group/hand/package.xml", package("hand"));
  (void)folder.write("base/old_arm/package.xml", package("arm"));
  const std::string path = (folder / "overlay").string() + ":" + (folder / "base").string();
  const RosPackages found = findRosPackages(path);
  EXPECT_THAT(namesOf(found), ElementsAre("arm", "hand"));
  EXPECT_EQ(found.sound.front().folder, folder / "overlay/arm");
}

TEST(RosPackages, AreNotLookedForWhereRospackDoesNot) {
  const test::TemporaryFolder folder;
  (void)folder.write("src/outer/package.xml", package("outer"));
  (void)folder.write("src/outer/inner/package.xml", package("inner"));
  (void)folder.write("src/.git/hidden/package.xml", package("hidden"));
  (void)folder.write("src/ignored/CATKIN_IGNORE", "");
  (void)folder.write("src/ignored/package.xml", package("ignored"));
  std::filesystem::create_directory_symlink(folder / "src", folder / "src/circle");
  EXPECT_THAT(namesOf(findRosPackages((folder / "src").string())), ElementsAre("outer"));
}

TEST(RosPackages, OneThatIsBrokenCostsNoOther) {
  const test::TemporaryFolder folder;
  (void)folder.write("src/broken/package.xml", "<package>\n<name>b</package>");
  (void)folder.write("src/good/package.xml", package("good"));
  const RosPackages found = findRosPackages((folder / "src").string());
  EXPECT_THAT(namesOf(found), ElementsAre("good"));
  ASSERT_EQ(found.broken.size(), 1U);
  EXPECT_THAT(found.broken.front().second, HasSubstr("broken/package.xml: line 2 cannot be read"));
}

TEST(RosPackages, TellWhatTheyExportForGazebo) {
  const test::TemporaryFolder folder;
  (void)folder.write("src/worlds/package.xml",
                     package("worlds",
                             "<export><gazebo_ros gazebo_model_path='${prefix}/models:${prefix}/..'"
                             " gazebo_media_path='${prefix}'/></export>"));
  const RosPackage found = findRosPackages((folder / "src").string()).sound.at(0);
  EXPECT_THAT(found.gazebo_models,
              ElementsAre((folder / "src/worlds/models").string(), (folder / "src/").string()));
  EXPECT_THAT(found.gazebo_media, ElementsAre((folder / "src/worlds").string()));
}

TEST(RosPackages, OfRos2AreInTheSharesOfItsPrefixes) {
  setenv("ROS_PACKAGE_PATH", "/home/me/src", 1);
  setenv("AMENT_PREFIX_PATH", "/home/me/install:/opt/ros/jazzy", 1);
  EXPECT_EQ(rosPackagePath(),
            "/home/me/src:/home/me/install/share:/opt/ros/jazzy/share:/usr/share");
  unsetenv("AMENT_PREFIX_PATH");
  unsetenv("ROS_PACKAGE_PATH");
  EXPECT_EQ(rosPackagePath(), "/usr/share");
}

TEST(RosPackages, AreNoneWhereThereIsNoPath) {
  EXPECT_THAT(findRosPackages("").sound, IsEmpty());
  EXPECT_THAT(findRosPackages("/nowhere:/dev/null").sound, IsEmpty());
}

}  // namespace ros_packages_test
}  // namespace synthetic_dataset::base

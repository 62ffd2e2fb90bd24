#include "world/files/resource_finder.h"

#include <cstdlib>

#include <gmock/gmock.h>

#include "support/temporary_folder.h"

namespace synthetic_dataset::world {
namespace resource_finder_test {

using synthetic_dataset::test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::Optional;

/// An environment variable for as long as it lives.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    setenv(name, value.c_str(), 1);
  }
  ~Variable() { unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
};

TEST(ResourceFinder, FindsModelsInItsFolders) {
  const TemporaryFolder folder;
  const auto file = folder.write("table/model.sdf", "");
  const ResourceFinder finder({"/nowhere", folder.path().string()}, nullptr);
  EXPECT_THAT(finder.find("model://table/model.sdf", "/"), Optional(file));
  EXPECT_THAT(finder.find("model://table/", "/"), Optional(file.parent_path()));
}

TEST(ResourceFinder, TakesNoDeviceForAFile) {
  const ResourceFinder finder({}, nullptr);
  EXPECT_EQ(finder.find("file:///dev/zero", "/"), std::nullopt);
  EXPECT_EQ(finder.find("/dev/null", "/"), std::nullopt);
}

TEST(ResourceFinder, PrefersItsOwnFoldersToTheEnvironments) {
  const TemporaryFolder own;
  const TemporaryFolder other;
  const auto file = own.write("table/model.sdf", "");
  other.write("table/model.sdf", "");
  const Variable path("GAZEBO_MODEL_PATH", other.path().string());
  const ResourceFinder finder({own.path().string()}, nullptr);
  EXPECT_THAT(finder.find("model://table/model.sdf", "/"), Optional(file));
}

TEST(ResourceFinder, ReadsTheEnvironmentsFoldersInOrder) {
  const TemporaryFolder gazebo;
  const TemporaryFolder sdf;
  const auto first = gazebo.write("a", "");
  sdf.write("a", "");
  const auto second = sdf.write("b", "");
  const Variable gazebo_path("GAZEBO_MODEL_PATH", "/nowhere:" + gazebo.path().string());
  const Variable sdf_path("SDF_PATH", sdf.path().string());
  const ResourceFinder finder({}, nullptr);
  EXPECT_THAT(finder.find("model://a", "/"), Optional(first));
  EXPECT_THAT(finder.find("model://b", "/"), Optional(second));
}

TEST(ResourceFinder, FindsPackages) {
  const TemporaryFolder folder;
  const auto file = folder.write("meshes/arm.dae", "");
  const ResourceFinder finder({}, [&](const std::string& package) -> std::optional<std::string> {
    if (package == "robot") return folder.path().string();
    return std::nullopt;
  });
  EXPECT_THAT(finder.find("package://robot/meshes/arm.dae", "/"), Optional(file));
  EXPECT_THAT(finder.find("model://robot/meshes/arm.dae", "/"), Optional(file));
  EXPECT_EQ(finder.find("package://other/meshes/arm.dae", "/"), std::nullopt);
}

TEST(ResourceFinder, TakesPlainPathsFromTheNamingFilesFolder) {
  const TemporaryFolder folder;
  const auto file = folder.write("meshes/arm.dae", "");
  const ResourceFinder finder({}, nullptr);
  EXPECT_THAT(finder.find("../meshes/arm.dae", folder / "sdf"), Optional(file));
  EXPECT_THAT(finder.find(file.string(), "/"), Optional(file));
  EXPECT_THAT(finder.find("file://" + file.string(), "/"), Optional(file));
}

TEST(ResourceFinder, NeverAsksTheNetwork) {
  const ResourceFinder finder({}, nullptr);
  const std::string uri = "https://fuel.gazebosim.org/1.0/models/table";
  EXPECT_EQ(finder.find(uri, "/"), std::nullopt);
  EXPECT_EQ(finder.searchedPlaces(uri, "/"), "nothing is fetched from the network");
}

TEST(ResourceFinder, TellsWhereItLooked) {
  const ResourceFinder finder({"/models/a", "/models/b"}, nullptr);
  EXPECT_THAT(finder.searchedPlaces("model://table/x.dae", "/"),
              HasSubstr("looked in /models/a/table/x.dae, /models/b/table/x.dae"));
  EXPECT_EQ(finder.searchedPlaces("x.dae", "/worlds"), "looked in /worlds/x.dae");
}

TEST(ResourceFinder, TellsOfAPackageThatRosDoesNotKnow) {
  const ResourceFinder finder({"/models"}, [](const std::string& name) {
    return name == "known" ? std::optional<std::string>("/packages/known") : std::nullopt;
  });
  EXPECT_THAT(finder.searchedPlaces("package://husky/a.dae", "/"),
              HasSubstr("; ROS knows no package 'husky'"));
  EXPECT_THAT(finder.searchedPlaces("package://known/a.dae", "/"), Not(HasSubstr("ROS knows no")));
}

TEST(ResourceFinder, FindsNothingForAnEmptyUri) {
  const ResourceFinder finder({"/"}, nullptr);
  EXPECT_EQ(finder.find("", "/"), std::nullopt);
  EXPECT_EQ(finder.find("model://", "/"), std::nullopt);
}

}  // namespace resource_finder_test
}  // namespace synthetic_dataset::world

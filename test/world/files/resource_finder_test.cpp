#include "world/files/resource_finder.h"

#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>

#include "support/temporary_folder.h"

namespace synthetic_dataset::world {
namespace resource_finder_test {

using synthetic_dataset::test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::Optional;

/// An environment variable that is set for as long as the object lives.
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

TEST(ResourceFinder, LeavesItToThoseWhoOpenADeviceToNameIt) {
  const ResourceFinder finder({}, nullptr);
  EXPECT_THAT(finder.find("file:///dev/zero", "/"), Optional(std::filesystem::path("/dev/zero")));
  EXPECT_THAT(finder.find("/dev/null", "/"), Optional(std::filesystem::path("/dev/null")));
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
  EXPECT_THAT(finder.find("file://package://robot/meshes/arm.dae", "/"), Optional(file))
      << "as file://$(find robot)/meshes/arm.dae becomes";
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

TEST(ResourceFinder, KnowsWhatIsSpeltNearlyAlike) {
  const test::TemporaryFolder folder;
  (void)folder.write("street.world", "<sdf/>");
  const ResourceFinder finder({folder.path().string()}, nullptr);
  EXPECT_THAT(finder.searchedPlaces("sreet.world", folder.path()),
              HasSubstr("; did you mean 'street.world'?"));
  EXPECT_THAT(finder.searchedPlaces("model://sreet.world", "/"),
              HasSubstr("; did you mean 'street.world'?"));
}

TEST(ResourceFinder, TellsWhereItLooked) {
  const ResourceFinder finder({"/models/a", "/models/b"}, nullptr);
  EXPECT_THAT(finder.searchedPlaces("model://table/x.dae", "/"),
              HasSubstr("looked in /models/a, /models/b"));
  EXPECT_THAT(finder.searchedPlaces("x.dae", "/worlds"),
              HasSubstr("looked in /worlds/x.dae, /models/a, /models/b"));
}

TEST(ResourceFinder, TellsOfAPackageThatRosDoesNotKnow) {
  const ResourceFinder finder({"/models"}, [](const std::string& name) {
    return name == "known" ? std::optional<std::string>("/packages/known") : std::nullopt;
  });
  EXPECT_THAT(finder.searchedPlaces("package://husky/a.dae", "/"),
              HasSubstr("; ROS knows no package 'husky'"));
  EXPECT_THAT(finder.searchedPlaces("package://known/a.dae", "/"), Not(HasSubstr("ROS knows no")));
}

TEST(ResourceFinder, LooksIntoResourceFoldersAsGazeboDoes) {
  const TemporaryFolder folder;
  const auto plain = folder.write("share/worlds/a.dae", "");
  const auto model = folder.write("share/models/table/b.dae", "");
  const auto media = folder.write("share/media/models/c.dae", "");
  const auto old_media = folder.write("share/Media/models/d.dae", "");
  const Variable path("GAZEBO_RESOURCE_PATH", (folder / "share").string());
  const ResourceFinder finder({}, nullptr);
  EXPECT_THAT(finder.find("file://worlds/a.dae", "/"), Optional(plain));
  EXPECT_THAT(finder.find("file://models/table/b.dae", "/"), Optional(model));
  EXPECT_THAT(finder.find("table/b.dae", "/"), Optional(model));
  EXPECT_THAT(finder.find("file://c.dae", "/"), Optional(media));
  EXPECT_THAT(finder.find("d.dae", "/"), Optional(old_media));
  EXPECT_EQ(finder.find("model://table/b.dae", "/"), std::nullopt);
}

TEST(ResourceFinder, FindsNamesWithoutASchemeAmongModels) {
  const TemporaryFolder folder;
  const auto file = folder.write("models/coast/model.config", "");
  const Variable path("SDF_PATH", (folder / "models").string());
  const ResourceFinder finder({}, nullptr);
  EXPECT_THAT(finder.find("coast", "/"), Optional(file.parent_path()));
}

TEST(ResourceFinder, PrefersWhatIsBesideTheNamingFile) {
  const TemporaryFolder folder;
  (void)folder.write("share/wall.png", "");
  const auto beside = folder.write("world/wall.png", "");
  const Variable path("GAZEBO_RESOURCE_PATH", (folder / "share").string());
  const ResourceFinder finder({}, nullptr);
  EXPECT_THAT(finder.find("file://wall.png", folder / "world"), Optional(beside));
}

TEST(ResourceFinder, AsksPackagesForTheirExportsOnlyWhenSomethingIsMissing) {
  const TemporaryFolder folder;
  (void)folder.write("known/table/model.sdf", "");
  const auto model = folder.write("exported/chair/model.sdf", "");
  const auto media = folder.write("media/models/lamp.dae", "");
  int asked = 0;
  const ResourceFinder finder({(folder / "known").string()}, nullptr, [&] {
    ++asked;
    return ExportedFolders{{(folder / "exported").string()}, {(folder / "media").string()}};
  });
  EXPECT_NE(finder.find("model://table/model.sdf", "/"), std::nullopt);
  EXPECT_EQ(asked, 0);
  EXPECT_THAT(finder.find("model://chair/model.sdf", "/"), Optional(model));
  EXPECT_THAT(finder.find("file://models/lamp.dae", "/"), Optional(media));
  EXPECT_THAT(finder.find("chair", "/"), Optional(model.parent_path()));
}

TEST(ResourceFinder, NamesTheFoldersThatSomebodyHasChosenAndCountsThoseOfPackages) {
  const ResourceFinder finder({"/models/mine"}, nullptr, [] {
    return ExportedFolders{{"/opt/a/models", "/opt/b/models", "/models/mine"}, {}};
  });
  const std::string places = finder.searchedPlaces("model://chair/model.sdf", "/");
  EXPECT_THAT(places, HasSubstr("looked in /models/mine"));
  EXPECT_THAT(places, HasSubstr(", 2 folders that ROS packages export for Gazebo"));
  EXPECT_THAT(places, Not(HasSubstr("/opt/")));
}

TEST(ResourceFinder, RefusesToLeadOutOfItsFolders) {
  const TemporaryFolder folder;
  const auto neighbour = folder.write("models/b/x.png", "");
  (void)folder.write("models/a/x.png", "");
  (void)folder.write("secret.png", "");
  const ResourceFinder finder({(folder / "models").string()}, nullptr);
  EXPECT_THAT(finder.find("model://a/../b/x.png", "/"), Optional(neighbour));
  EXPECT_TRUE(finder.refusals().empty());
  for (const char* uri : {"model://a/../../secret.png", "model://a/%2e%2e/%2E./secret.png",
                          "model://a/..\\..\\secret.png", "package://a/../../secret.png"}) {
    EXPECT_EQ(finder.find(uri, "/"), std::nullopt) << uri;
    EXPECT_TRUE(finder.leadsOut(uri, "/")) << uri;
    EXPECT_THAT(finder.searchedPlaces(uri, "/"), HasSubstr("leads out of the folders")) << uri;
  }
  EXPECT_EQ(finder.refusals().size(), 4U);
}

TEST(ResourceFinder, LetsAPackageNameItsNeighboursAndNothingElse) {
  const TemporaryFolder folder;
  (void)folder.write("src/arm/package.xml", "");
  const auto neighbour = folder.write("src/hand/hand.dae", "");
  (void)folder.write("secret.dae", "");
  const ResourceFinder finder({}, [&](const std::string& name) {
    return name == "arm" ? std::optional((folder / "src/arm").string()) : std::nullopt;
  });
  EXPECT_THAT(finder.find("package://arm/../hand/hand.dae", "/"), Optional(neighbour));
  EXPECT_EQ(finder.find("package://arm/../../secret.dae", "/"), std::nullopt);
  EXPECT_THAT(finder.refusals(), testing::ElementsAre(HasSubstr("secret.dae")));
}

TEST(ResourceFinder, LetsPlainPathsLeadAnywhereButNotOutOfSearchedFolders) {
  const TemporaryFolder folder;
  const auto file = folder.write("textures/x.png", "");
  const Variable path("GAZEBO_RESOURCE_PATH", (folder / "share").string());
  const ResourceFinder finder({}, nullptr);
  EXPECT_THAT(finder.find("../textures/x.png", folder / "worlds"), Optional(file));
  EXPECT_EQ(finder.find("../textures/x.png", "/a/b"), std::nullopt);
  EXPECT_TRUE(finder.refusals().empty());
}

TEST(ResourceFinder, RefusesToLeadOutOfFuelsCache) {
  const TemporaryFolder folder;
  (void)folder.write("secret", "");
  const Variable cache("GZ_FUEL_CACHE_PATH", (folder / "cache").string());
  const ResourceFinder finder({}, nullptr);
  const std::string uri =
      "https://fuel.gazebosim.org/1.0/x/models/y/1/files/..%2f..%2f..%2f..%2f..%2f..%2fsecret";
  EXPECT_EQ(finder.find(uri, "/"), std::nullopt);
  EXPECT_TRUE(finder.leadsOut(uri, "/"));
}

TEST(ResourceFinder, FindsNothingForAnEmptyUri) {
  const ResourceFinder finder({"/"}, nullptr);
  EXPECT_EQ(finder.find("", "/"), std::nullopt);
  EXPECT_EQ(finder.find("model://", "/"), std::nullopt);
}

}  // namespace resource_finder_test
}  // namespace synthetic_dataset::world

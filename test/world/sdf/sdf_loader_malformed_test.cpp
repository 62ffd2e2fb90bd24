#include <sys/stat.h>

#include <filesystem>

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "world/sdf/sdf_loader_support.h"
#include "world/world_loader.h"

namespace synthetic_dataset::world {
namespace sdf_loader_malformed_test {

namespace fs = std::filesystem;

using namespace test;

std::string worldWith(const std::string& geometry) {
  return worldFile(modelElement("m", linkElement(visualElement(geometry))));
}

TEST(MalformedSdf, IncludesItselfByAnotherPath) {
  const TemporaryFolder folder;
  folder.write("models/a/a.sdf",
               modelFile("a", linkElement() + includeElement("../../models/b/../a/a.sdf")));
  fs::create_directories(folder / "models/b");
  fs::create_symlink(folder / "models", folder / "link");
  const std::string text = worldFile(includeElement("link/a/a.sdf"));
  EXPECT_THAT(errorsOf(folder, text), ElementsAre(HasSubstr("includes itself")));
}

TEST(MalformedSdf, IncludesTheWorldFileItself) {
  const TemporaryFolder folder;
  EXPECT_THAT(errorsOf(folder, worldFile(includeElement("world.sdf"))),
              ElementsAre(AllOf(HasSubstr("world.sdf: line 1: include 'world.sdf'"),
                                HasSubstr("includes itself, by way of 1 file(s)"))));
}

TEST(MalformedSdf, MultipliesItself) {
  const TemporaryFolder folder;
  folder.write("0.sdf", modelFile("m", linkElement()));
  for (int level = 1; level <= 30; ++level) {
    std::string content = linkElement();
    for (int i = 0; i < 10; ++i) {
      content += includeElement(std::to_string(level - 1) + ".sdf",
                                "<name>m" + std::to_string(i) + "</name>");
    }
    folder.write(std::to_string(level) + ".sdf", modelFile("m", content));
  }
  EXPECT_THAT(errorsOf(folder, worldFile(includeElement("30.sdf"))),
              Contains(HasSubstr("includes more than 20000 files")));
}

TEST(MalformedSdf, NestsTooDeep) {
  const TemporaryFolder folder;
  for (int level = 0; level < 40; ++level) {
    folder.write(
        std::to_string(level) + ".sdf",
        modelFile("m", linkElement() + includeElement(std::to_string(level + 1) + ".sdf")));
  }
  EXPECT_THAT(errorsOf(folder, worldFile(includeElement("0.sdf"))),
              Contains(HasSubstr("included by files more than 30 deep")));
}

TEST(MalformedSdf, LeavesTheModelsFolder) {
  const TemporaryFolder folder;
  folder.write("shared.obj", test::kTriangleObj);
  folder.write("a/a.sdf", modelFile("a", linkElement(visualElement(meshElement("../shared.obj")))));
  EXPECT_THAT(loadText(folder, worldFile(includeElement("a/a.sdf"))).notes, IsEmpty());
  EXPECT_THAT(errorsOf(folder, worldWith(meshElement("../../../../../../../../../gone.obj"))),
              ElementsAre(HasSubstr("looked in /gone.obj")));
}

/// A world with a visual "v0", "v1", ... for each geometry.
std::string worldWithAll(const std::vector<std::string>& geometries) {
  std::string visuals;
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    visuals += "<visual name='v" + std::to_string(i) + "'><geometry>" + geometries[i] +
               "</geometry></visual>";
  }
  return worldFile(modelElement("m", linkElement(visuals)));
}

TEST(MalformedSdf, HasPathsThatAreNone) {
  const TemporaryFolder folder;
  fs::create_symlink(folder / "loop.obj", folder / "loop.obj");
  fs::create_directories(folder / "folder.obj");
  const std::vector<std::string> uris{std::string(5000, 'x') + ".obj",
                                      "loop.obj",
                                      "folder.obj",
                                      "model://",
                                      "%00",
                                      "a%zz%",
                                      "/dev/null",
                                      "model://../../../etc/passwd",
                                      "://x",
                                      "http://"};
  std::vector<std::string> geometries;
  for (const std::string& uri : uris) geometries.push_back(meshElement(uri));
  const std::vector<std::string> errors = errorsOf(folder, worldWithAll(geometries));
  ASSERT_EQ(errors.size(), uris.size());
  for (std::size_t i = 0; i < uris.size(); ++i) {
    EXPECT_THAT(errors[i], HasSubstr("world.sdf: line 1: model 'm': link 'body': visual 'v" +
                                     std::to_string(i) + "': mesh '"));
  }
}

TEST(MalformedSdf, HasPathsWithEscapesAndBackslashes) {
  const TemporaryFolder folder;
  folder.write("my meshes/a b.obj", test::kTriangleObj);
  EXPECT_THAT(errorsOf(folder, worldWithAll({meshElement("my meshes/a b.obj"),
                                             meshElement("my%20meshes/a%20b.obj"),
                                             meshElement("my meshes\\a b.obj"),
                                             meshElement("file://my%20meshes/a b.obj")})),
              IsEmpty());
}

TEST(MalformedSdf, HasIncludesThatAreNone) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "empty");
  for (const std::string include :
       {"<include/>", "<include><uri/></include>", "<include><uri> </uri></include>",
        "<include><uri>empty</uri></include>"}) {
    EXPECT_THAT(errorsOf(folder, worldFile(include)), ElementsAre(HasSubstr("world.sdf: line 1: ")))
        << include;
    EXPECT_THAT(loadWithoutMissing(folder, worldFile(include)).notes,
                ElementsAre(HasSubstr("(left out)")))
        << include;
  }
}

TEST(MalformedSdf, HasDevicesForFilesWhichAreNeverLeftOut) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe.obj").c_str(), 0600), 0);
  ASSERT_EQ(mkfifo((folder / "pipe.png").c_str(), 0600), 0);
  const std::string texture =
      "<model name='m'><link name='l'><visual name='v'><geometry><box><size>1 1 1</size></box>"
      "</geometry><material><pbr><metal><albedo_map>pipe.png</albedo_map></metal></pbr></material>"
      "</visual></link></model>";
  for (const std::string& world : {worldFile("<include><uri>/dev/zero</uri></include>"),
                                   worldWithAll({meshElement("pipe.obj")}), worldFile(texture)}) {
    EXPECT_THAT(test::messagesOf([&] { (void)loadWithoutMissing(folder, world); }),
                ElementsAre(HasSubstr("is a pipe or a device; a file is needed")))
        << world;
  }
}

TEST(MalformedSdf, HasAbsurdNumbersWhichCostTheirVisualAlone) {
  const TemporaryFolder folder;
  folder.write("y.obj", test::kTriangleObj);
  for (const std::string& geometry :
       {meshElement("y.obj", "<scale>1e300 1e300 1e300</scale>"),
        meshElement("y.obj", "<scale>1 0 1</scale>"),
        std::string("<box><size>1e300 1 1</size></box>"),
        std::string("<box><size>1 0 1</size></box>"),
        std::string("<sphere><radius>-2</radius></sphere>"),
        std::string("<cylinder><radius>1e39</radius><length>1</length></cylinder>"),
        std::string("<cylinder><radius>1</radius><length>0</length></cylinder>"),
        std::string("<plane><normal>0 0 0</normal><size>1 1</size></plane>"),
        std::string("<plane><normal>0 0 1</normal><size>-1 nan</size></plane>"),
        std::string("<heightmap><uri>y.obj</uri><size>1e300 1 1</size></heightmap>"),
        std::string("<polyline><point>1e300 0</point><point>1 0</point><point>1 1</point>"
                    "<height>1</height></polyline>")}) {
    const Description world = loadText(folder, worldWith(geometry));
    EXPECT_THAT(world.models.at(0).links.at(0).visuals, IsEmpty()) << geometry;
    EXPECT_THAT(
        world.notes,
        ElementsAre(AllOf(HasSubstr("world.sdf: line 1: model 'm': link 'body': visual 'v': "),
                          HasSubstr("; it is left out"))))
        << geometry;
  }
}

TEST(MalformedSdf, HasWhatAreNoNumbersAndTakesTheUsualOnes) {
  const TemporaryFolder folder;
  const Description world = loadText(folder, worldWith("<box><size>one 1 1</size></box>"));
  EXPECT_THAT(world.models.at(0).links.at(0).visuals, SizeIs(1));
  EXPECT_THAT(world.notes,
              ElementsAre(HasSubstr("visual 'v': size: found 'one 1 1'; three numbers are needed; "
                                    "1 1 1 is taken")));
}

TEST(MalformedSdf, HasPosesThatAreNone) {
  const TemporaryFolder folder;
  const auto load = [&](const std::string& pose) {
    return loadText(folder,
                    worldFile("\n" + modelElement("m", "\n<pose>" + pose + "</pose>" +
                                                           linkElement(visualElement(kBox)))));
  };
  const Description far = load("1e300 0 0 0 0 0");
  EXPECT_THAT(far.notes,
              ElementsAre(HasSubstr("world.sdf: line 3: model 'm': pose: found '1e300 0")));
  EXPECT_TRUE(far.models.at(0).X_WM.isApprox(Pose::Identity()));
  const Description short_one = load("1 2 three");
  EXPECT_THAT(short_one.notes,
              ElementsAre(HasSubstr("6 numbers are needed; the others are taken for 0")));
  EXPECT_TRUE(short_one.models.at(0).X_WM.translation().isApprox(Eigen::Vector3d(1, 2, 0)));
}

TEST(MalformedSdf, HasAPolylineThatIsNone) {
  const TemporaryFolder folder;
  const auto polyline = [](const std::string& points) {
    return worldWith("<polyline>" + points + "<height>1</height></polyline>");
  };
  EXPECT_THAT(
      errorsOf(folder, polyline("<point>0 0</point><point>1 0</point>")),
      ElementsAre(AllOf(HasSubstr("world.sdf: line 1: model 'm': link 'body': visual 'v': "),
                        HasSubstr("2 different points"))));
  EXPECT_THAT(errorsOf(folder, polyline("<point>0 0</point><point>2 2</point><point>2 0</point>"
                                        "<point>0 3</point>")),
              ElementsAre(HasSubstr("crosses itself")));
}

TEST(MalformedSdf, HasAHeightmapWithoutAPicture) {
  const TemporaryFolder folder;
  folder.write("empty.png", "");
  const auto heightmap = [](const std::string& uri) {
    return worldWith("<heightmap><uri>" + uri + "</uri><size>1 1 1</size></heightmap>");
  };
  EXPECT_THAT(errorsOf(folder, heightmap("gone.png")),
              ElementsAre(HasSubstr("visual 'v': heightmap 'gone.png': no such file; looked in ")));
  EXPECT_THAT(errorsOf(folder, heightmap("empty.png")),
              ElementsAre(AllOf(HasSubstr("visual 'v': picture '"), HasSubstr("is empty"))));
  EXPECT_THAT(loadWithoutMissing(folder, heightmap("gone.png")).notes,
              ElementsAre(HasSubstr("(left out)")));
}

TEST(MalformedSdf, IsATemplateThatNobodyHasExpanded) {
  const TemporaryFolder folder;
  const auto at = [](const std::string& pose) {
    return worldFile(modelElement("m", "<pose>" + pose + "</pose>" + linkElement()));
  };
  EXPECT_THAT(
      errorsOf(folder, at("0 ${y} 0 0 0 0")),
      ElementsAre(AllOf(HasSubstr("line 1: '0 ${y} 0 0 0 0' is xacro's"), HasSubstr(".xacro"))));
  EXPECT_THAT(errorsOf(folder, at("{{ x }} 0 0 0 0 0")),
              ElementsAre(AllOf(HasSubstr("is Jinja's"), HasSubstr(".jinja"))));
  EXPECT_THAT(errorsOf(folder, "<sdf version='1.6'>\n<% 3.times do %>\n<world name='w'/></sdf>"),
              ElementsAre(HasSubstr("line 2: '<%' is ERB's")));
  const std::string plugin = "<plugin name='p' filename='f'><text>${HOME}</text></plugin>";
  EXPECT_NO_THROW((void)loadText(folder, worldFile(modelElement("m", linkElement() + plugin))));
  const std::string unused = "<xacro:arg name='material' default='Grey'/>";
  EXPECT_NO_THROW((void)loadText(folder, worldFile(modelElement("m", unused + linkElement()))));
}

}  // namespace sdf_loader_malformed_test
}  // namespace synthetic_dataset::world

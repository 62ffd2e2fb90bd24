#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "world/sdf/sdf_loader_support.h"
#include "world/world_loader.h"

namespace synthetic_dataset::world {
namespace sdf_loader_errors_test {

using namespace test;

std::string worldWith(const std::string& visual) {
  return worldFile(modelElement("shelf", linkElement(visual)));
}

TEST(SdfLoaderErrors, TellWhereAMissingWorldWasLookedFor) {
  const TemporaryFolder folder;
  EXPECT_THAT(errorsOfFile(folder, "model://gone/world.sdf"),
              ElementsAre(AllOf(HasSubstr("'model://gone/world.sdf': no such file"),
                                HasSubstr("looked in " + folder.path().string()))));
}

TEST(SdfLoaderErrors, NameAModelThatListsAFileOutsideOfItsFolder) {
  const TemporaryFolder folder;
  folder.write("secret.sdf", modelFile("m", linkElement("")));
  folder.write("models/a/model.config", "<model><sdf version='1.6'>../../secret.sdf</sdf></model>");
  EXPECT_THAT(errorsOfFile(folder, (folder / "models/a").string()),
              ElementsAre(AllOf(HasSubstr("secret.sdf', which is not in the model's folder"))));
}

TEST(SdfLoaderErrors, NameAFolderWithoutModelConfig) {
  const TemporaryFolder folder;
  folder.write("empty/readme.txt", "");
  EXPECT_THAT(errorsOfFile(folder, "model://empty"),
              ElementsAre(AllOf(HasSubstr("model://empty"), HasSubstr("model.config"))));
}

TEST(SdfLoaderErrors, NameTheLineOfWhatIsNotXml) {
  const TemporaryFolder folder;
  EXPECT_THAT(errorsOf(folder, "<sdf version='1.6'>\n<world name='w'>\n</sdf>"),
              ElementsAre(HasSubstr(
                  "world.sdf: line 2: cannot be read as XML (XML_ERROR_MISMATCHED_ELEMENT)")));
  EXPECT_THAT(errorsOf(folder, ""), ElementsAre(HasSubstr("cannot be read as XML")));
}

TEST(SdfLoaderErrors, NameARootThatIsNotSdf) {
  const TemporaryFolder folder;
  EXPECT_THAT(errorsOf(folder, "<html/>"),
              ElementsAre(AllOf(HasSubstr("<html>"), HasSubstr("<sdf> is needed"))));
}

TEST(SdfLoaderErrors, TellWhatUrdfsParserSays) {
  const TemporaryFolder folder;
  const auto file = folder.write("robot.urdf",
                                 "<robot name='r'><link name='a'/><link name='a'/>"
                                 "</robot>");
  EXPECT_THAT(errorsOfFile(folder, file.string()), Contains(HasSubstr("link 'a' is there twice")));
}

TEST(SdfLoaderErrors, TellWhereAMissingMeshWasLookedFor) {
  const TemporaryFolder folder;
  EXPECT_THAT(
      errorsOf(folder, worldWith(visualElement(meshElement("model://x/y.dae")))),
      ElementsAre(AllOf(HasSubstr("world.sdf: line 1: model 'shelf': link 'body': visual 'v': mesh "
                                  "'model://x/y.dae': no such file; looked in "),
                        HasSubstr(folder.path().string()))));
}

TEST(SdfLoaderErrors, NameTheIncludedFile) {
  const TemporaryFolder folder;
  folder.write("part.sdf", modelFile("part", linkElement(visualElement(meshElement("y.dae")))));
  EXPECT_THAT(errorsOf(folder, worldFile(includeElement("part.sdf"))),
              ElementsAre(StartsWith((folder / "part.sdf").string() + ": line 1: model 'part': ")));
}

TEST(SdfLoaderErrors, NameAMeshThatCannotBeRead) {
  const TemporaryFolder folder;
  folder.write("y.dae", "no COLLADA");
  EXPECT_THAT(errorsOf(folder, worldWith(visualElement(meshElement("y.dae")))),
              ElementsAre(AllOf(HasSubstr("visual 'v': mesh '" + (folder / "y.dae").string()),
                                HasSubstr("cannot be read"))));
}

TEST(SdfLoaderErrors, NameAMissingTexture) {
  const TemporaryFolder folder;
  folder.write("y.mtl", "newmtl a\nmap_Kd gone.png\n");
  folder.write("y.obj", "mtllib y.mtl\nusemtl a\n" + std::string(test::kTriangleObj));
  EXPECT_THAT(errorsOf(folder, worldWith(visualElement(meshElement("y.obj")))),
              ElementsAre(HasSubstr("visual 'v': texture 'gone.png': no such file; looked in " +
                                    (folder / "gone.png").string())));
}

TEST(SdfLoaderErrors, NameAnIncludeThatIsNotThere) {
  const TemporaryFolder folder;
  EXPECT_THAT(
      errorsOf(folder, worldFile("\n" + includeElement("model://gone"))),
      ElementsAre(AllOf(HasSubstr("world.sdf: line 2: include 'model://gone': no such file"),
                        HasSubstr("looked in " + folder.path().string()))));
}

TEST(SdfLoaderErrors, SayThatNothingIsFetched) {
  const TemporaryFolder folder;
  EXPECT_THAT(
      errorsOf(folder, worldFile(includeElement("https://fuel.gazebosim.org/1.0/x/models/y"))),
      ElementsAre(HasSubstr("nothing is fetched from the network")));
}

TEST(SdfLoaderErrors, NameFilesThatIncludeOneAnother) {
  const TemporaryFolder folder;
  folder.write("a.sdf", modelFile("a", "<link name='l'/>" + includeElement("b.sdf")));
  folder.write("b.sdf", modelFile("b", "<link name='l'/>" + includeElement("a.sdf")));
  EXPECT_THAT(errorsOf(folder, worldFile(includeElement("a.sdf"))),
              ElementsAre(AllOf(StartsWith((folder / "b.sdf").string()),
                                HasSubstr("include 'a.sdf': includes itself"))));
}

TEST(SdfLoaderErrors, ComeAllAtOnce) {
  const TemporaryFolder folder;
  folder.write("b.dae", "no COLLADA, which is not seen before all that is missing is reported");
  const std::string text =
      worldFile(includeElement("model://gone") +
                modelElement("a", linkElement(visualElement(meshElement("a.dae")))) +
                modelElement("b", linkElement(visualElement(meshElement("b.dae")))));
  EXPECT_THAT(errorsOf(folder, text),
              ElementsAre(HasSubstr("include 'model://gone'"), HasSubstr("'a.dae'")));
}

TEST(SdfLoaderErrors, AreNotPrinted) {
  const TemporaryFolder folder;
  const auto urdf = folder.write("robot.urdf", "<robot name='r'><link/></robot>");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  static_cast<void>(errorsOf(folder, worldFile(includeElement("model://gone") + "<bogus/>")));
  static_cast<void>(
      errorsOf(folder, worldFile(modelElement("m", "<link name='a'><pose>x</pose></link>"))));
  static_cast<void>(errorsOfFile(folder, urdf.string()));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(SdfLoaderErrors, SurviveGarbage) {
  const TemporaryFolder folder;
  const std::string good =
      worldFile(includeElement("model://x") + modelElement("m", linkElement(visualElement(kBox))));
  for (std::size_t length = 0; length < good.size(); ++length) {
    EXPECT_THAT(errorsOf(folder, good.substr(0, length)), Not(IsEmpty()));
  }
}

TEST(SdfLoaderErrors, NameAFileWithoutAModel) {
  const TemporaryFolder folder;
  const auto file = folder.write("world.sdf", worldFile(""));
  EXPECT_THAT(test::messagesOf([&] {
                static_cast<void>(loadModel(file.string(), "alpha", test::finderIn(folder)));
              }),
              testing::ElementsAre(AllOf(HasSubstr("has 0 models"), HasSubstr("'alpha'"))));
}

}  // namespace sdf_loader_errors_test
}  // namespace synthetic_dataset::world

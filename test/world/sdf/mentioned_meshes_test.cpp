#include "world/sdf/mentioned_meshes.h"

#include <gmock/gmock.h>

#include "world/sdf/include_graph.h"
#include "world/sdf/sdf_loader_support.h"

namespace synthetic_dataset::world {
namespace mentioned_meshes_test {

using test::includeElement;
using test::linkElement;
using test::meshElement;
using test::modelElement;
using test::modelFile;
using test::TemporaryFolder;
using test::visualElement;
using testing::AllOf;
using testing::ElementsAre;
using testing::Field;

/// The meshes of a world's file and what it draws in.
std::vector<MentionedMesh> meshesOf(const TemporaryFolder& folder, const std::string& text) {
  const ResourceFinder finder = test::finderIn(folder);
  Findings findings;
  return IncludeGraph(folder.write("world.sdf", text), finder, findings).meshes();
}

testing::Matcher<MentionedMesh> isMesh(const std::string& uri, bool shows_pictures) {
  return AllOf(Field(&MentionedMesh::uri, uri),
               Field(&MentionedMesh::shows_pictures, shows_pictures));
}

TEST(MentionedMeshes, TellWhosePicturesAreSeen) {
  const TemporaryFolder folder;
  const std::string link = linkElement(
      visualElement(meshElement("own.dae")) +
      visualElement(meshElement("painted.dae"), "<material><diffuse>1 0 0 1</diffuse></material>") +
      "<collision name='c'><geometry>" + meshElement("hull.stl") + "</geometry></collision>");
  EXPECT_THAT(meshesOf(folder, test::worldFile(modelElement("m", link))),
              ElementsAre(isMesh("own.dae", true), isMesh("painted.dae", false),
                          isMesh("hull.stl", false)));
}

TEST(MentionedMeshes, AreThoseOfIncludedFilesToo) {
  const TemporaryFolder folder;
  folder.write("m/inner.sdf", modelFile("i", linkElement(visualElement(meshElement("i.dae")))));
  folder.write("m/m.sdf", modelFile("m", linkElement(visualElement(meshElement("m.dae"))) +
                                             includeElement("inner.sdf")));
  const auto meshes = meshesOf(folder, test::worldFile(includeElement("m/m.sdf")));
  EXPECT_THAT(meshes, testing::UnorderedElementsAre(isMesh("i.dae", true), isMesh("m.dae", true)));
  EXPECT_THAT(meshes, testing::Each(Field(&MentionedMesh::folder, folder / "m")));
}

TEST(MentionedMeshes, AreNoneOfWorldsThatAreNotRead) {
  const TemporaryFolder folder;
  const auto world = [](const std::string& mesh) {
    return "<world name='" + mesh + "'>" +
           modelElement("m", linkElement(visualElement(meshElement(mesh)))) + "</world>";
  };
  EXPECT_THAT(meshesOf(folder, "<sdf version='1.7'>" + world("a.dae") + world("b.dae") + "</sdf>"),
              ElementsAre(isMesh("a.dae", true)));
}

}  // namespace mentioned_meshes_test
}  // namespace synthetic_dataset::world

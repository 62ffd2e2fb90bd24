#include <opencv2/imgcodecs.hpp>

#include "world/sdf/sdf_loader_support.h"

namespace synthetic_dataset::world {
namespace sdf_script_test {

using namespace test;

std::string script(const std::string& name, const std::string& uris, const std::string& rest = "") {
  return "<material><script>" + uris + "<name>" + name + "</name></script>" + rest + "</material>";
}

Material materialOf(const TemporaryFolder& folder, const std::string& material,
                    const std::string& geometry = kBox) {
  return test::loadVisual(folder, visualElement(geometry, material)).surfaces.at(0).material;
}

std::vector<std::string> errorsOfMaterial(const TemporaryFolder& folder,
                                          const std::string& material) {
  return test::errorsOf(folder,
                        worldFile(modelElement("m", linkElement(visualElement(kBox, material)))));
}

constexpr const char* kScript =
    "material Shelf/Red\n{\n technique\n {\n  pass\n  {\n   diffuse 1 0 0\n   texture_unit\n   {\n"
    "    texture red.png\n   }\n  }\n }\n}\n";

/// A model's folder as Gazebo's users lay it out.
void writeShelf(const TemporaryFolder& folder, const std::string& picture_folder) {
  folder.write("shelf/materials/scripts/shelf.material", kScript);
  const auto path = folder / ("shelf/" + picture_folder);
  std::filesystem::create_directories(path);
  cv::imwrite((path / "red.png").string(), cv::Mat(1, 1, CV_8UC3, cv::Scalar(1, 2, 3)));
}

TEST(SdfScript, IsFoundInAFolderOfScripts) {
  const TemporaryFolder folder;
  writeShelf(folder, "materials/textures");
  const Material found = materialOf(folder, script("Shelf/Red",
                                                   "<uri>model://shelf/materials/scripts</uri>"
                                                   "<uri>model://shelf/materials/textures</uri>"));
  EXPECT_EQ(found.diffuse, Eigen::Vector4f(1, 0, 0, 1));
  ASSERT_NE(found.texture, nullptr);
  EXPECT_EQ(found.texture->file, (folder / "shelf/materials/textures/red.png").string());
}

TEST(SdfScript, IsFoundInAFileAndItsPictureBesideItsFolder) {
  const TemporaryFolder folder;
  writeShelf(folder, "materials/textures");
  EXPECT_NE(materialOf(folder, script("Shelf/Red",
                                      "<uri>model://shelf/materials/scripts/shelf.material</uri>"))
                .texture,
            nullptr);
}

TEST(SdfScript, IsFoundByItsNameInGazebosMediaFolders) {
  const TemporaryFolder folder;
  folder.write("share/media/materials/scripts/shelf.material", kScript);
  std::filesystem::create_directories(folder / "share/media/materials/textures");
  cv::imwrite((folder / "share/media/materials/textures/red.png").string(),
              cv::Mat(1, 1, CV_8UC3, cv::Scalar(1, 2, 3)));
  const ResourceFinder finder({}, nullptr, [&] {
    return ExportedFolders{{}, {(folder / "share").string()}};
  });
  const Description world = loadWorld(
      folder
          .write("world.sdf", worldFile(modelElement(
                                  "m", linkElement(visualElement(kBox, script("Shelf/Red", ""))))))
          .string(),
      finder);
  const Material& found = world.models.at(0).links.at(0).visuals.at(0).surfaces.at(0).material;
  EXPECT_EQ(found.diffuse, Eigen::Vector4f(1, 0, 0, 1));
  EXPECT_NE(found.texture, nullptr);
}

TEST(SdfScript, FindsPicturesInAnyFolderThatIsNamed) {
  const TemporaryFolder folder;
  writeShelf(folder, "pictures");
  EXPECT_NE(materialOf(folder, script("Shelf/Red",
                                      "<uri>model://shelf/materials/scripts</uri>"
                                      "<uri>model://shelf/pictures</uri>"))
                .texture,
            nullptr);
}

TEST(SdfScript, InheritsFromWhatItImports) {
  const TemporaryFolder folder;
  folder.write("s/base.material", "material Base { technique { pass { diffuse 0 1 0 } } }");
  folder.write("s/own.material", "import Base from \"base.material\"\nmaterial Own : Base { }");
  EXPECT_EQ(materialOf(folder, script("Own", "<uri>s/own.material</uri>")).diffuse,
            Eigen::Vector4f(0, 1, 0, 1));
}

TEST(SdfScript, TakesThePlaceOfTheMeshsMaterial) {
  const TemporaryFolder folder;
  folder.write("a.mtl", "newmtl m\nKd 0 0 1\n");
  folder.write("a.obj", "mtllib a.mtl\nusemtl m\n" + std::string(test::kTriangleObj));
  EXPECT_EQ(materialOf(folder, script("Gazebo/Red", ""), test::meshElement("a.obj")).diffuse,
            Eigen::Vector4f(1, 0, 0, 1));
}

TEST(SdfScript, KnowsWhatGazeboShips) {
  const TemporaryFolder folder;
  const std::string uri = "<uri>file://media/materials/scripts/gazebo.material</uri>";
  EXPECT_EQ(materialOf(folder, script("Gazebo/Grey", uri)).diffuse,
            Eigen::Vector4f(0.7F, 0.7F, 0.7F, 1));
  EXPECT_NE(materialOf(folder, script("Gazebo/Wood", uri)).texture, nullptr);
}

TEST(SdfScript, YieldsToColoursOfTheFile) {
  const TemporaryFolder folder;
  writeShelf(folder, "materials/textures");
  const Material found =
      materialOf(folder, script("Shelf/Red", "<uri>model://shelf/materials/scripts</uri>",
                                "<diffuse>0 1 0 1</diffuse><ambient>0 0 1 1</ambient>"
                                "<lighting>false</lighting>"));
  EXPECT_EQ(found.diffuse, Eigen::Vector4f(0, 1, 0, 1));
  EXPECT_NE(found.texture, nullptr);
  EXPECT_FALSE(found.lit);
}

TEST(SdfScript, IsNotLookedForWhereGazeboSavedAWorld) {
  const TemporaryFolder folder;
  const Material found =
      materialOf(folder, script("ModelPreview_1::link::visual_MATERIAL_", "<uri>__default__</uri>",
                                "<diffuse>0.7 0.6 0.5 1</diffuse>"));
  EXPECT_EQ(found.diffuse, Eigen::Vector4f(0.7F, 0.6F, 0.5F, 1));
}

TEST(SdfScript, TellsWhereAnUnknownMaterialWasLookedFor) {
  const TemporaryFolder folder;
  writeShelf(folder, "materials/textures");
  EXPECT_THAT(errorsOfMaterial(folder, script("Shelf/Blue",
                                              "<uri>model://shelf/materials/scripts</uri>"
                                              "<uri>model://shelf/elsewhere</uri>")),
              ElementsAre(AllOf(HasSubstr("visual 'v': material 'Shelf/Blue' is in no script"),
                                HasSubstr("shelf.material"), HasSubstr("'model://shelf/elsewhere'"),
                                HasSubstr("and Gazebo ships none of that name"))));
  EXPECT_THAT(
      test::notesOf(folder, worldFile(modelElement(
                                "m", linkElement(visualElement(kBox, script("Gazebo/Gray", "")))))),
      ElementsAre(HasSubstr("material 'Gazebo/Gray' is in no script (no <uri> names a "
                            "script or a folder with scripts), and Gazebo ships none of "
                            "that name; did you mean 'Gazebo/Grey'?; the default "
                            "material is drawn")));
}

TEST(SdfScript, TellsFileAndLineOfAMalformedScript) {
  const TemporaryFolder folder;
  folder.write("bad.material", "material A\n{\n technique\n {\n");
  EXPECT_THAT(errorsOfMaterial(folder, script("A", "<uri>bad.material</uri>")),
              ElementsAre(HasSubstr("bad.material: line 3: the section 'technique' has no '}'")));
}

TEST(SdfScript, TellsOfAPictureThatIsMissing) {
  const TemporaryFolder folder;
  folder.write("s/a.material", kScript);
  EXPECT_THAT(errorsOfMaterial(folder, script("Shelf/Red", "<uri>s</uri>")),
              ElementsAre(AllOf(HasSubstr("material 'Shelf/Red': texture 'red.png': no such file"),
                                HasSubstr((folder / "s").string()))));
}

}  // namespace sdf_script_test
}  // namespace synthetic_dataset::world

#include <opencv2/imgcodecs.hpp>

#include "world/sdf/sdf_loader_support.h"
#include "world/world_loader.h"

namespace synthetic_dataset::world {
namespace sdf_loader_visual_test {

using namespace test;

/// A red OBJ mesh with a picture beside it.
void writeTexturedMesh(const TemporaryFolder& folder, const std::string& model) {
  folder.write(model + "/meshes/part.obj",
               "mtllib part.mtl\nusemtl red\n" + std::string(kTriangleObj));
  folder.write(model + "/meshes/part.mtl",
               "newmtl red\nKd 1 0 0\nKs 0.5 0.5 0.5\nd 0.5\nmap_Kd picture.png\n");
  cv::imwrite((folder / (model + "/meshes/picture.png")).string(),
              cv::Mat(2, 2, CV_8UC3, cv::Scalar(10, 20, 30)));
}

Material material(const TemporaryFolder& folder, const std::string& geometry,
                  const std::string& rest) {
  return loadVisual(folder, visualElement(geometry, rest)).surfaces.at(0).material;
}

TEST(SdfVisual, HasTheShapesSize) {
  const TemporaryFolder folder;
  const Visual visual = loadVisual(folder, visualElement(kBox));
  Eigen::Vector3f largest = Eigen::Vector3f::Zero();
  for (const Eigen::Vector3f& position : visual.surfaces.at(0).mesh->positions) {
    largest = largest.cwiseMax(position);
  }
  EXPECT_EQ(largest, Eigen::Vector3f(0.5F, 1.0F, 1.5F));
}

TEST(SdfVisual, ReadsColours) {
  const TemporaryFolder folder;
  const Material found = material(folder, kBox,
                                  "<material><diffuse>0.1 0.2 0.3 0.5</diffuse>"
                                  "<specular>0.4 0.5 0.6 1</specular>"
                                  "<emissive>0.7 0.8 0.9 1</emissive>"
                                  "<double_sided>true</double_sided></material>");
  EXPECT_TRUE(found.diffuse.isApprox(Eigen::Vector4f(0.1F, 0.2F, 0.3F, 0.5F)));
  EXPECT_TRUE(found.specular.isApprox(Eigen::Vector3f(0.4F, 0.5F, 0.6F)));
  EXPECT_TRUE(found.emissive.isApprox(Eigen::Vector3f(0.7F, 0.8F, 0.9F)));
  EXPECT_TRUE(found.double_sided);
}

TEST(SdfVisual, MultipliesAlphaByTransparency) {
  const TemporaryFolder folder;
  const Material found = material(
      folder, kBox,
      "<transparency>0.75</transparency><material><diffuse>1 1 1 0.5</diffuse></material>");
  EXPECT_FLOAT_EQ(found.diffuse.w(), 0.125F);
}

TEST(SdfVisual, IsLeftOutWhereItCannotBeSeen) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, worldFile(modelElement(
                  "m", linkElement(visualElement(kBox, "<transparency>1</transparency>")))));
  EXPECT_THAT(world.models.at(0).links.at(0).visuals, IsEmpty());
}

TEST(SdfVisual, ReadsCastShadows) {
  const TemporaryFolder folder;
  EXPECT_TRUE(loadVisual(folder, visualElement(kBox)).casts_shadow);
  EXPECT_FALSE(
      loadVisual(folder, visualElement(kBox, "<cast_shadows>false</cast_shadows>")).casts_shadow);
}

TEST(SdfVisual, ShowsAMeshInItsOwnMaterial) {
  const TemporaryFolder folder;
  writeTexturedMesh(folder, "box");
  const Material found = material(folder, meshElement("model://box/meshes/part.obj"), "");
  EXPECT_TRUE(found.diffuse.isApprox(Eigen::Vector4f(1, 0, 0, 0.5F)));
  EXPECT_TRUE(found.specular.isApprox(Eigen::Vector3f(0.5F, 0.5F, 0.5F)));
  ASSERT_NE(found.texture, nullptr);
  EXPECT_EQ(found.texture->file, (folder / "box/meshes/picture.png").string());
}

TEST(SdfVisual, PrefersItsMaterialToTheMeshs) {
  const TemporaryFolder folder;
  writeTexturedMesh(folder, "box");
  const Material found = material(folder, meshElement("model://box/meshes/part.obj"),
                                  "<material><diffuse>0 1 0 1</diffuse></material>");
  EXPECT_EQ(found.diffuse, Eigen::Vector4f(0, 1, 0, 1));
  EXPECT_EQ(found.texture, nullptr);
}

TEST(SdfVisual, ReadsPbrMetalFromTheIncludedModelsFolder) {
  const TemporaryFolder folder;
  folder.write("crate/model.config",
               "<model><name>c</name><sdf version='1.7'>model.sdf</sdf></model>");
  folder.write("crate/model.sdf",
               test::modelFile("crate", linkElement(visualElement(
                                            kBox,
                                            "<material><diffuse>1 1 1 1</diffuse><pbr><metal>"
                                            "<albedo_map>textures/a.png</albedo_map>"
                                            "<roughness>0.25</roughness><metalness>0.75</metalness>"
                                            "</metal></pbr></material>"))));
  std::filesystem::create_directories(folder / "crate/textures");
  cv::imwrite((folder / "crate/textures/a.png").string(), cv::Mat::zeros(1, 1, CV_8UC3));
  const Description world =
      loadText(folder, worldFile("<include><uri>model://crate</uri></include>"));
  const Material found = world.models.at(0).links.at(0).visuals.at(0).surfaces.at(0).material;
  ASSERT_NE(found.texture, nullptr);
  EXPECT_FLOAT_EQ(found.roughness, 0.25F);
  EXPECT_FLOAT_EQ(found.metalness, 0.75F);
}

TEST(SdfVisual, TakesMeshesFromTheIncludedModelsFolder) {
  const TemporaryFolder folder;
  writeTexturedMesh(folder, "far/away");
  folder.write("far/away/model.sdf",
               test::modelFile("m", linkElement(visualElement(meshElement("meshes/part.obj")))));
  const Description world =
      loadText(folder, worldFile("<include><uri>far/away/model.sdf</uri></include>"));
  EXPECT_THAT(world.models.at(0).links.at(0).visuals, SizeIs(1));
}

TEST(SdfVisual, SharesMeshesAndPictures) {
  const TemporaryFolder folder;
  writeTexturedMesh(folder, "box");
  const std::string link = linkElement(visualElement(meshElement("model://box/meshes/part.obj")));
  const Description world =
      loadText(folder, worldFile(modelElement("a", link) + modelElement("b", link)));
  const Surface& first = world.models.at(0).links.at(0).visuals.at(0).surfaces.at(0);
  const Surface& second = world.models.at(1).links.at(0).visuals.at(0).surfaces.at(0);
  EXPECT_EQ(first.mesh, second.mesh);
  EXPECT_EQ(first.material.texture, second.material.texture);
}

TEST(SdfVisual, ScalesMeshes) {
  const TemporaryFolder folder;
  folder.write("part.obj", kTriangleObj);
  const Visual visual =
      loadVisual(folder, visualElement(meshElement("part.obj", "<scale>2 3 4</scale>")));
  EXPECT_EQ(visual.surfaces.at(0).mesh->positions.at(2), Eigen::Vector3f(0, 6, 0));
}

}  // namespace sdf_loader_visual_test
}  // namespace synthetic_dataset::world

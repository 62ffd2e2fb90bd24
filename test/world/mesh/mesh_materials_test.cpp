#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>

#include "world/material/material_conversions.h"
#include "world/mesh/assimp_gaps.h"
#include "world/mesh/mesh_loader.h"
#include "world/sdf/sdf_loader_support.h"

namespace synthetic_dataset::world {
namespace mesh_materials_test {

using test::kTriangleObj;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class MeshMaterialTest : public testing::Test {
 protected:
  MeshRequest write(const std::string& name, const std::string& content) const {
    MeshRequest request;
    request.file = folder_.write(name, content);
    return request;
  }
  /// A triangle in a material of an MTL file.
  MeshRequest obj(const std::string& mtl) const {
    folder_.write("a.mtl", "newmtl m\n" + mtl);
    return write("a.obj", "mtllib a.mtl\nusemtl m\n" + std::string(kTriangleObj));
  }
  void writePicture(const std::string& name, const cv::Mat& pixels) const {
    cv::imwrite((folder_ / name).string(), pixels);
  }
  Material materialOf(const MeshRequest& request) {
    const std::size_t index = loader_.pieces(request).at(0).material;
    return loader_.material(request, index,
                            [&](const std::string& message) { missing_.push_back(message); });
  }
  const Mesh& meshOf(const MeshRequest& request) { return *loader_.pieces(request).at(0).mesh; }

  TemporaryFolder folder_;
  ResourceFinder finder_ = test::finderIn(folder_);
  MeshLoader loader_{finder_};
  std::vector<std::string> missing_;
};

TEST_F(MeshMaterialTest, TakesAnObjsExponentForRoughness) {
  EXPECT_FLOAT_EQ(materialOf(obj("Kd 1 0 0\nKs 1 1 1\nNs 100\n")).roughness,
                  roughnessOfShininess(100));
}

TEST_F(MeshMaterialTest, ReadsAnObjsOpacityPicture) {
  writePicture("c.png", cv::Mat(2, 2, CV_8UC3, cv::Scalar(1, 2, 3)));
  writePicture("o.png", cv::Mat(2, 2, CV_8UC1, cv::Scalar(50)));
  const Material found = materialOf(obj("Kd 1 1 1\nmap_Kd c.png\nmap_d o.png\n"));
  ASSERT_NE(found.texture, nullptr);
  EXPECT_EQ(found.texture->pixels.at<cv::Vec4b>(0, 0), cv::Vec4b(1, 2, 3, 50));
}

TEST_F(MeshMaterialTest, ReadsAnObjsBumpPicture) {
  writePicture("b.png", cv::Mat(4, 4, CV_8UC1, cv::Scalar(50)));
  const Material found = materialOf(obj("Kd 1 1 1\nmap_Bump b.png\n"));
  ASSERT_NE(found.normal_map, nullptr);
  EXPECT_EQ(found.normal_map->pixels.at<cv::Vec4b>(0, 0), cv::Vec4b(255, 128, 128, 255));
}

TEST_F(MeshMaterialTest, ShowsTheColourWithoutAPictureThatIsMissing) {
  const Material found = materialOf(obj("Kd 1 0 0\nmap_Kd none.png\n"));
  EXPECT_THAT(missing_, testing::ElementsAre(HasSubstr("texture 'none.png': no such file")));
  EXPECT_EQ(found.diffuse, Eigen::Vector4f(1, 0, 0, 1));
  EXPECT_EQ(found.texture, nullptr);
}

/// glTF: one triangle (0 0 0, 1 0 0, 0 2 0), its numbers in base 64; those of the positions are
/// also its vertex colours and texture coordinates.
std::string gltf(const std::string& material, const std::string& more = "") {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0, "name": "part"}], "materials": [)" +
         material + "]" + more + R"(,
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 2, "TEXCOORD_0": 3},
                                "indices": 1, "material": 0}]}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
       "min": [0, 0, 0], "max": [1, 2, 0]},
      {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"},
      {"bufferView": 2, "componentType": 5126, "count": 3, "type": "VEC3"},
      {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC2"}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36},
                    {"buffer": 0, "byteOffset": 36, "byteLength": 6},
                    {"buffer": 0, "byteOffset": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 44, "uri": "data:application/octet-stream;base64,)" +
         std::string("AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAEAAAAAAAAABAAIAAAA=") + R"("}]})";
}

std::string texture(const std::string& picture) {
  return R"(, "images": [{"uri": ")" + picture + R"("}], "textures": [{"source": 0}])";
}

TEST_F(MeshMaterialTest, ReadsGltfsMetallicRoughnessPicture) {
  writePicture("p.png", cv::Mat(1, 1, CV_8UC3, cv::Scalar(10, 20, 30)));
  const Material found = materialOf(
      write("a.gltf", gltf(R"({"pbrMetallicRoughness": {"metallicRoughnessTexture": {"index": 0},
                               "roughnessFactor": 0.5}})",
                           texture("p.png"))));
  ASSERT_NE(found.roughness_map, nullptr);
  EXPECT_EQ(found.roughness_map, found.metalness_map);
  EXPECT_EQ(found.roughness_map->pixels.at<cv::Vec4b>(0, 0), cv::Vec4b(10, 20, 30, 255));
  EXPECT_FLOAT_EQ(found.roughness, 0.5F);
  EXPECT_FLOAT_EQ(found.metalness, 1.0F);
}

TEST_F(MeshMaterialTest, ReadsGltfsNormalAndEmissivePictures) {
  writePicture("p.png", cv::Mat(1, 1, CV_8UC3, cv::Scalar(255, 128, 128)));
  const Material found = materialOf(
      write("a.gltf", gltf(R"({"normalTexture": {"index": 0}, "emissiveTexture": {"index": 0},
                         "emissiveFactor": [1, 0, 0]})",
                           texture("p.png"))));
  EXPECT_NE(found.normal_map, nullptr);
  EXPECT_NE(found.emissive_map, nullptr);
  EXPECT_TRUE(found.emissive.isApprox(Eigen::Vector3f(1, 0, 0)));
}

TEST_F(MeshMaterialTest, ReadsGltfsAlphaModes) {
  writePicture("p.png", cv::Mat(1, 1, CV_8UC4, cv::Scalar(1, 2, 3, 4)));
  const std::string colour =
      R"("pbrMetallicRoughness": {"baseColorTexture": {"index": 0},
         "baseColorFactor": [1, 1, 1, 0.5]}})";
  const Material mask = materialOf(write(
      "m.gltf", gltf(R"({"alphaMode": "MASK", "alphaCutoff": 0.25, )" + colour, texture("p.png"))));
  EXPECT_FLOAT_EQ(mask.alpha_threshold, 0.5F);  // of the picture's alpha, which the factor halves
  EXPECT_EQ(mask.diffuse.w(), 1.0F);
  EXPECT_EQ(mask.texture->pixels.at<cv::Vec4b>(0, 0)[3], 4);
  const Material blend =
      materialOf(write("b.gltf", gltf(R"({"alphaMode": "BLEND", )" + colour, texture("p.png"))));
  EXPECT_TRUE(blend.texture_is_glass);
  EXPECT_EQ(blend.diffuse.w(), 0.5F);
  const Material opaque = materialOf(write("o.gltf", gltf("{" + colour, texture("p.png"))));
  EXPECT_EQ(opaque.diffuse.w(), 1.0F);
  EXPECT_EQ(opaque.texture->pixels.at<cv::Vec4b>(0, 0)[3], 255);
}

TEST_F(MeshMaterialTest, ReadsGltfsUnlitMaterials) {
  const std::string unlit = R"({"extensions": {"KHR_materials_unlit": {}}})";
  EXPECT_FALSE(
      materialOf(write("a.gltf", gltf(unlit, R"(, "extensionsUsed": ["KHR_materials_unlit"])")))
          .lit);
  EXPECT_TRUE(materialOf(write("b.gltf", gltf("{}"))).lit);
}

TEST_F(MeshMaterialTest, ReadsGltfsTextureTransform) {
  writePicture("p.png", cv::Mat(1, 1, CV_8UC3, cv::Scalar(1, 2, 3)));
  const Material found = materialOf(write(
      "a.gltf", gltf(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "extensions":
                  {"KHR_texture_transform": {"offset": [0.25, 0.125], "scale": [2, 4]}}}}})",
                     texture("p.png") + R"(, "extensionsUsed": ["KHR_texture_transform"])")));
  if (assimpHasGaps()) {  // the loader notes it
    EXPECT_TRUE(found.texture_scale.isOnes());
    return;
  }
  // KHR_texture_transform: scaled, then shifted, with v downwards as in our meshes.
  EXPECT_TRUE(found.texture_scale.isApprox(Eigen::Vector2f(2, 4)));
  EXPECT_TRUE(found.texture_offset.isApprox(Eigen::Vector2f(0.25F, 0.125F)));
}

TEST_F(MeshMaterialTest, ReadsGltfsLinearVertexColours) {
  const Mesh& mesh = meshOf(write("a.gltf", gltf("{}")));
  ASSERT_THAT(mesh.colours, SizeIs(mesh.positions.size()));
  // The positions double as colours: the second vertex is linear red, the first one black.
  EXPECT_EQ(mesh.colours[0], Eigen::Vector4f(0, 0, 0, 1));
  EXPECT_TRUE(mesh.colours[1].isApprox(Eigen::Vector4f(1, 0, 0, 1)));
}

TEST_F(MeshMaterialTest, ReadsPlysVertexColoursOnWhite) {
  const MeshRequest request =
      write("a.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
            "0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 51\n3 0 1 2\n");
  const Mesh& mesh = meshOf(request);
  ASSERT_THAT(mesh.colours, SizeIs(3));
  EXPECT_TRUE(mesh.colours[2].isApprox(Eigen::Vector4f(0, 0, 0.2F, 1)));
  EXPECT_EQ(materialOf(request).diffuse, Eigen::Vector4f(1, 1, 1, 1));
}

TEST_F(MeshMaterialTest, ReadsObjsVertexColours) {
  const MeshRequest request =
      write("a.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3\n");
  EXPECT_THAT(meshOf(request).colours, SizeIs(3));
  EXPECT_EQ(materialOf(request).diffuse, Eigen::Vector4f(1, 1, 1, 1));
}

/// A binary STL file of one triangle whose attribute bytes are given.
std::string binaryStl(std::uint16_t attribute) {
  std::string file(80, '\0');
  const auto add = [&](const auto& value) {
    file.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  add(std::uint32_t{1});
  for (const float number : {0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) {
    add(number);
  }
  add(attribute);
  return file;
}

TEST_F(MeshMaterialTest, ReadsVisCamsColoursOfBinaryStlFiles) {
  // Bit 15 says that there is a colour; below it are five bits each of red, green and blue.
  const MeshRequest request = write("a.stl", binaryStl(0x8000U | 31U << 10U));
  const Mesh& mesh = meshOf(request);
  if (assimpHasGaps()) {  // its colours would be wrong
    EXPECT_THAT(mesh.colours, IsEmpty());
    return;
  }
  ASSERT_THAT(mesh.colours, SizeIs(3));
  EXPECT_TRUE(mesh.colours[0].isApprox(Eigen::Vector4f(1, 0, 0, 1)));
  EXPECT_EQ(materialOf(request).diffuse, Eigen::Vector4f(1, 1, 1, 1));
  EXPECT_THAT(meshOf(write("b.stl", binaryStl(0))).colours, IsEmpty());
}

}  // namespace mesh_materials_test
}  // namespace synthetic_dataset::world

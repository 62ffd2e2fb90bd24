#include "world/mesh/mesh_loader.h"

#include <Eigen/Geometry>

#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>

#include "world/sdf/sdf_loader_support.h"

namespace synthetic_dataset::world {
namespace mesh_loader_test {

using test::kTriangleObj;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;

/// COLLADA: a triangle (0 0 0, 1 0 0, 0 2 0), moved by its node; then what the caller adds.
std::string collada(const std::string& asset, const std::string& images = "",
                    const std::string& diffuse = "<color>1 0 0 1</color>",
                    const std::string& more_nodes = "") {
  return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset>)" +
         asset + R"(</asset>
<library_images>)" +
         images + R"(</library_images>
<library_effects><effect id="e"><profile_COMMON>
 <newparam sid="surface"><surface type="2D"><init_from>picture</init_from></surface></newparam>
 <newparam sid="sampler"><sampler2D><source>surface</source></sampler2D></newparam>
 <technique sid="common"><lambert><diffuse>)" +
         diffuse + R"(</diffuse></lambert></technique>
</profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g" name="shape"><mesh>
 <source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 0 2 0</float_array>
  <technique_common><accessor source="#pa" count="3" stride="3"><param name="X" type="float"/>
  <param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
 <source id="t"><float_array id="ta" count="6">0 0 1 0 0 0.75</float_array>
  <technique_common><accessor source="#ta" count="3" stride="2"><param name="S" type="float"/>
  <param name="T" type="float"/></accessor></technique_common></source>
 <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
 <triangles count="1" material="M"><input semantic="VERTEX" source="#v" offset="0"/>
  <input semantic="TEXCOORD" source="#t" offset="1" set="0"/><p>0 0 1 1 2 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n" name="first">
 <translate>0 0 5</translate><instance_geometry url="#g"><bind_material><technique_common>
 <instance_material symbol="M" target="#m"/></technique_common></bind_material></instance_geometry>
</node>)" +
         more_nodes + R"(</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

constexpr const char* kInches = "<unit name='inch' meter='0.0254'/><up_axis>Z_UP</up_axis>";
constexpr const char* kMetresYUp = "<unit name='meter' meter='1'/><up_axis>Y_UP</up_axis>";
constexpr const char* kMetres = "<unit name='meter' meter='1'/><up_axis>Z_UP</up_axis>";

class MeshLoaderTest : public testing::Test {
 protected:
  MeshRequest request(const std::string& name, const std::string& content) const {
    MeshRequest result;
    result.file = folder_.write(name, content);
    return result;
  }

  Eigen::AlignedBox3f bounds(const MeshRequest& request) {
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3f& position : loader_.whole(request)->positions) box.extend(position);
    return box;
  }

  std::string errorOf(const MeshRequest& request) {
    try {
      static_cast<void>(loader_.pieces(request));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  /// The material of the file's first piece.
  Material materialOf(const MeshRequest& request) {
    const auto fail = [](const std::string& message) { throw Error(message); };
    return loader_.material(request, loader_.pieces(request)[0].material, fail);
  }

  TemporaryFolder folder_;
  ResourceFinder finder_ = test::finderIn(folder_);
  MeshLoader loader_{finder_};
};

TEST_F(MeshLoaderTest, ReadsObj) {
  const auto mesh = loader_.whole(request("a.obj", kTriangleObj));
  ASSERT_THAT(mesh->positions, SizeIs(3));
  EXPECT_EQ(mesh->positions[2], Eigen::Vector3f(0, 2, 0));
  EXPECT_THAT(mesh->indices, testing::ElementsAre(0, 1, 2));
}

TEST_F(MeshLoaderTest, MakesNormalsWhereThereAreNone) {
  const auto mesh = loader_.whole(request("a.obj", kTriangleObj));
  for (const Eigen::Vector3f& normal : mesh->normals) {
    EXPECT_TRUE(normal.isApprox(Eigen::Vector3f::UnitZ()));
  }
}

TEST_F(MeshLoaderTest, MakesNormalsForZeroOnesOfStlFiles) {
  const auto mesh = loader_.whole(request("a.stl",
                                          "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\n"
                                          "vertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\n"
                                          "endsolid a\n"));
  ASSERT_THAT(mesh->normals, SizeIs(3));
  for (const Eigen::Vector3f& normal : mesh->normals) {
    EXPECT_TRUE(normal.isApprox(Eigen::Vector3f::UnitX()));
  }
}

TEST_F(MeshLoaderTest, KeepsSharpEdgesOfGeneratedNormals) {
  // Two squares that meet at a right angle along the y axis.
  const auto mesh = loader_.whole(request("roof.obj",
                                          "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 0 1 1\n"
                                          "f 1 2 3 4\nf 1 4 6 5\n"));
  for (const Eigen::Vector3f& normal : mesh->normals) {
    EXPECT_NEAR(normal.cwiseAbs().maxCoeff(), 1.0F, 1e-6F);
  }
}

TEST_F(MeshLoaderTest, PutsTheTexturesFirstRowAtZero) {
  const auto mesh = loader_.whole(request("a.obj", kTriangleObj));
  // In OBJ files, v is 0 at the picture's lower edge.
  EXPECT_EQ(mesh->texture_coordinates[0], Eigen::Vector2f(0, 1));
  EXPECT_EQ(mesh->texture_coordinates[2], Eigen::Vector2f(0, 0));
}

TEST_F(MeshLoaderTest, AppliesColladasUnitAndNodes) {
  const auto box = bounds(request("a.dae", collada(kInches)));
  EXPECT_TRUE(box.min().isApprox(Eigen::Vector3f(0, 0, 0.127F), 1e-6F));
  EXPECT_TRUE(box.max().isApprox(Eigen::Vector3f(0.0254F, 0.0508F, 0.127F), 1e-6F));
}

/// The default of Gazebo's common::Material.
TEST_F(MeshLoaderTest, GivesColladasWithoutAnAmbientColourThatOfGazebo) {
  std::string text = collada(kMetresYUp);
  EXPECT_EQ(materialOf(request("a.dae", text)).ambient, Eigen::Vector3f(0.4F, 0.4F, 0.4F));
  const std::string model = "<lambert>";
  text.insert(text.find(model) + model.size(), "<ambient><color>0 0.5 1 1</color></ambient>");
  EXPECT_EQ(materialOf(request("b.dae", text)).ambient, Eigen::Vector3f(0, 0.5F, 1));
}

TEST_F(MeshLoaderTest, DoesNotTurnYUpFilesAsGazeboDoesNot) {
  const auto box = bounds(request("a.dae", collada(kMetresYUp)));
  EXPECT_TRUE(box.min().isApprox(Eigen::Vector3f(0, 0, 5)));
  EXPECT_TRUE(box.max().isApprox(Eigen::Vector3f(1, 2, 5)));
}

TEST_F(MeshLoaderTest, ReadsColladasColour) {
  const MeshRequest wanted = request("a.dae", collada(kMetres));
  const Material material = materialOf(wanted);
  EXPECT_EQ(material.diffuse, Eigen::Vector4f(1, 0, 0, 1));
  EXPECT_EQ(material.specular, Eigen::Vector3f::Zero());
  EXPECT_EQ(material.texture, nullptr);
}

TEST_F(MeshLoaderTest, FindsPicturesInMaterialsTextures) {
  std::filesystem::create_directories(folder_ / "box/materials/textures");
  cv::imwrite((folder_ / "box/materials/textures/p.png").string(),
              cv::Mat(2, 3, CV_8UC3, cv::Scalar(1, 2, 3)));
  const MeshRequest wanted =
      request("box/meshes/a.dae",
              collada(kMetres, "<image id='picture'><init_from>C:\\work\\p.png</init_from></image>",
                      "<texture texture='sampler' texcoord='UV'/>"));
  const Material material = materialOf(wanted);
  ASSERT_NE(material.texture, nullptr);
  EXPECT_EQ(material.texture->pixels.at<cv::Vec4b>(0, 0), cv::Vec4b(1, 2, 3, 255));
  EXPECT_EQ(material.diffuse, Eigen::Vector4f(1, 1, 1, 1));
}

TEST_F(MeshLoaderTest, TakesAnImageWithoutFileForNoPicture) {
  const MeshRequest wanted = request(
      "a.dae",
      collada(kMetres, "<image id='picture'/>", "<texture texture='sampler' texcoord='UV'/>"));
  const Material material = materialOf(wanted);
  EXPECT_EQ(material.texture, nullptr);
}

/// glTF: one triangle (0 0 0, 1 0 0, 0 2 0), its numbers in base 64.
std::string gltf(const std::string& material) {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0, "name": "part"}], "materials": [)" +
         material + R"(],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
       "min": [0, 0, 0], "max": [1, 2, 0]},
      {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36},
                    {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
    "buffers": [{"byteLength": 44, "uri": "data:application/octet-stream;base64,)" +
         std::string("AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAEAAAAAAAAABAAIAAAA=") + R"("}]})";
}

TEST_F(MeshLoaderTest, ReadsGltf) {
  const MeshRequest wanted = request(
      "a.gltf", gltf(R"({"doubleSided": true, "pbrMetallicRoughness": {"metallicFactor": 0.25,
                        "roughnessFactor": 0.75, "baseColorFactor": [0.5, 0.25, 0, 1]}})"));
  EXPECT_TRUE(bounds(wanted).max().isApprox(Eigen::Vector3f(1, 2, 0)));
  const Material material = materialOf(wanted);
  // glTF's colours are linear: 0.5 is 188 of 255 in sRGB, 0.25 is 137.
  EXPECT_TRUE(material.diffuse.isApprox(Eigen::Vector4f(188 / 255.F, 137 / 255.F, 0, 1), 2e-3F));
  EXPECT_FLOAT_EQ(material.metalness, 0.25F);
  EXPECT_FLOAT_EQ(material.roughness, 0.75F);
  EXPECT_TRUE(material.double_sided);
}

TEST_F(MeshLoaderTest, TurnsTrianglesOfMirroredNodes) {
  const std::string mirrored =
      "<node name='second'><scale>-1 1 1</scale><instance_geometry url='#g'/></node>";
  MeshRequest wanted = request("a.dae", collada(kMetres, "", "<color>1 0 0 1</color>", mirrored));
  wanted.submesh = "second";
  const Mesh mesh = *loader_.whole(wanted);
  const Eigen::Vector3f a = mesh.positions[mesh.indices[0]];
  const Eigen::Vector3f b = mesh.positions[mesh.indices[1]];
  const Eigen::Vector3f c = mesh.positions[mesh.indices[2]];
  EXPECT_EQ((b - a).cross(c - a).normalized(), Eigen::Vector3f(0, 0, 1));
}

TEST_F(MeshLoaderTest, SelectsASubmeshAndCentresIt) {
  const std::string second =
      "<node name='second'><translate>10 0 0</translate><instance_geometry url='#g'/></node>";
  MeshRequest wanted = request("a.dae", collada(kMetres, "", "<color>1 0 0 1</color>", second));
  wanted.submesh = "second";
  EXPECT_TRUE(bounds(wanted).min().isApprox(Eigen::Vector3f(10, 0, 0)));
  wanted.centre_submesh = true;
  EXPECT_TRUE(bounds(wanted).min().isApprox(Eigen::Vector3f(-0.5F, -1, 0)));
  EXPECT_TRUE(bounds(wanted).max().isApprox(Eigen::Vector3f(0.5F, 1, 0)));
}

TEST_F(MeshLoaderTest, NamesTheSubmeshesThatThereAre) {
  MeshRequest wanted = request("a.dae", collada(kMetres));
  wanted.submesh = "firsd";
  EXPECT_THAT(errorOf(wanted), AllOf(HasSubstr("a.dae': has no submesh 'firsd'"),
                                     HasSubstr("'first'"), HasSubstr("did you mean")));
}

TEST_F(MeshLoaderTest, ScalesAndMirrors) {
  MeshRequest wanted = request("a.obj", kTriangleObj);
  wanted.scale = {-2, 1, 3};
  const Mesh mesh = *loader_.whole(wanted);
  const Eigen::Vector3f a = mesh.positions[mesh.indices[0]];
  const Eigen::Vector3f b = mesh.positions[mesh.indices[1]];
  const Eigen::Vector3f c = mesh.positions[mesh.indices[2]];
  EXPECT_EQ((b - a).cross(c - a), Eigen::Vector3f(0, 0, 4));  // twice the area, still upwards
  EXPECT_EQ(mesh.normals[0], Eigen::Vector3f(0, 0, 1));
}

TEST_F(MeshLoaderTest, SharesMeshes) {
  const MeshRequest wanted = request("a.obj", kTriangleObj);
  EXPECT_EQ(loader_.pieces(wanted)[0].mesh, loader_.pieces(wanted)[0].mesh);
  EXPECT_EQ(loader_.whole(wanted), loader_.pieces(wanted)[0].mesh);
  MeshRequest larger = wanted;
  larger.scale = {2, 2, 2};
  EXPECT_NE(loader_.whole(larger), loader_.whole(wanted));
}

TEST_F(MeshLoaderTest, RefusesAFileWithoutTriangles) {
  EXPECT_THAT(errorOf(request("a.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n")), HasSubstr("a.obj': "));
  EXPECT_THAT(errorOf(request("b.stl", "solid b\nendsolid b\n")), HasSubstr("b.stl': "));
}

TEST_F(MeshLoaderTest, RefusesAVertexThatIsNoNumber) {
  EXPECT_THAT(errorOf(request("a.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")),
              HasSubstr("a.obj': has a vertex that is not a number"));
}

TEST_F(MeshLoaderTest, RefusesGarbage) {
  const std::string garbage(1000, '\x93');
  for (const char* name : {"a.dae", "a.obj", "a.stl", "a.glb", "a.ply", "a.unknown"}) {
    EXPECT_THAT(errorOf(request(name, garbage)), HasSubstr(name));
  }
}

TEST_F(MeshLoaderTest, ReadsWhatItHasReadAheadNoMore) {
  const MeshRequest whole =
      request("t.obj", std::string("mtllib t.mtl\nusemtl p\n") + kTriangleObj);
  const MeshRequest torn = request("torn.dae", "<COLLADA>");
  folder_.write("t.mtl", "newmtl p\nmap_Kd p.png\n");
  cv::imwrite((folder_ / "p.png").string(), cv::Mat(1, 1, CV_8UC3, cv::Scalar(1, 2, 3)));
  loader_.readAhead({{whole.file, false}, {torn.file, true}, {whole.file, true}});
  EXPECT_TRUE(loader_.knows(whole.file));
  for (const char* name : {"t.obj", "p.png"}) {
    std::filesystem::resize_file(folder_ / name, 3);  // neither is read again
  }
  ASSERT_THAT(loader_.pieces(whole), SizeIs(1));
  const Material material = loader_.material(whole, loader_.pieces(whole)[0].material,
                                             [](const std::string& text) { FAIL() << text; });
  ASSERT_NE(material.texture, nullptr);
  EXPECT_EQ(material.texture->pixels.at<cv::Vec4b>(0, 0), cv::Vec4b(1, 2, 3, 255));
  EXPECT_THAT(errorOf(torn), HasSubstr("torn.dae"));
}

}  // namespace mesh_loader_test
}  // namespace synthetic_dataset::world

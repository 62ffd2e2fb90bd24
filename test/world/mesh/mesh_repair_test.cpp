/// Mesh files that Gazebo reads and assimp does not, or not correctly; and which other files a mesh
/// file may refer to.

#include <Eigen/Geometry>

#include <gmock/gmock.h>

#include <sys/stat.h>

#include "world/mesh/mesh_file.h"
#include "world/mesh/mesh_loader.h"
#include "world/mesh/obj_repair.h"
#include "world/sdf/sdf_loader_support.h"

namespace synthetic_dataset::world {
namespace mesh_repair_test {

using test::kTriangleObj;
using test::TemporaryFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// COLLADA: a triangle (0 0 0, 1 0 0, 0 2 0) in a colour, in a node with transformations.
std::string collada(const std::string& colour, const std::string& transformations,
                    const std::string& in_vertices = "") {
  return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis> Y_UP </up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="common"><lambert><diffuse>)" +
         colour + R"(</diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh>
 <source id="p"><float_array id="pa" count="9">
 0 0 0 1 0 0 0 2 0
 </float_array><technique_common><accessor source="#pa" count="3" stride="3">
 <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
 </accessor></technique_common></source>
 <vertices id="v"><input semantic="POSITION" source="#p"/>)" +
         in_vertices + R"(</vertices>
 <triangles count="1" material="M"><input semantic="VERTEX" source="#v" offset="0"/>
 <p> 0 1 2 </p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n">)" +
         transformations + R"(<instance_geometry url="#g"><bind_material><technique_common>
 <instance_material symbol="M" target="#m"/></technique_common></bind_material></instance_geometry>
</node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

class MeshRepair : public testing::Test {
 protected:
  MeshFile read(const std::string& name, const std::string& content) const {
    return readMeshFile(folder_.write(name, content));
  }

  static Eigen::AlignedBox3f bounds(const MeshFile& file) {
    Eigen::AlignedBox3f box;
    for (const MeshPart& part : file.parts) {
      for (const Eigen::Vector3f& position : part.mesh.positions) box.extend(position);
    }
    return box;
  }

  TemporaryFolder folder_;
};

TEST_F(MeshRepair, ReadsColladasColoursWithBlanksAroundThem) {
  const MeshFile file = read("a.dae", collada("<color> 1 0 0 1\n</color>", ""));
  EXPECT_EQ(file.materials.at(0).material.diffuse, Eigen::Vector4f(1, 0, 0, 1));
  EXPECT_TRUE(bounds(file).max().isApprox(Eigen::Vector3f(1, 2, 0)));
  EXPECT_TRUE(file.y_up);
}

TEST_F(MeshRepair, ReadsColladaWithCommentsInIt) {
  const MeshFile file = read("a.dae", collada("<color><!-- red -->1 0 0 1</color>", "<!-- none -->",
                                              "<!-- <input semantic='NORMAL' source='#n'/> -->"));
  EXPECT_EQ(file.parts.size(), 1U);
  EXPECT_EQ(file.materials.at(0).material.diffuse, Eigen::Vector4f(1, 0, 0, 1));
}

TEST_F(MeshRepair, TakesAColladaNodesMatrixAloneAsGazeboDoes) {
  const std::string colour = "<color>1 0 0 1</color>";
  const std::string matrix = "<matrix>1 0 0 5  0 1 0 0  0 0 1 0  0 0 0 1</matrix>";
  const std::string moved = "<translate>0 0 7</translate><scale>2 2 2</scale>";
  const MeshFile alone = read("a.dae", collada(colour, matrix + moved));
  EXPECT_TRUE(bounds(alone).max().isApprox(Eigen::Vector3f(6, 2, 0)));
  const MeshFile without = read("b.dae", collada(colour, moved));
  EXPECT_TRUE(bounds(without).max().isApprox(Eigen::Vector3f(2, 4, 7)));
}

TEST_F(MeshRepair, ShowsBothSidesWhereColladaSaysSo) {
  std::string text = collada("<color>1 0 0 1</color>", "");
  EXPECT_FALSE(read("a.dae", text).materials.at(0).material.double_sided);
  const std::string end = "</technique>";
  text.insert(text.find(end) + end.size(),
              "<extra><technique profile='GOOGLEEARTH'><double_sided>1</double_sided></technique>"
              "</extra>");
  EXPECT_TRUE(read("b.dae", text).materials.at(0).material.double_sided);
}

TEST_F(MeshRepair, ReadsNumbersOfObjThatBeginWithThePoint) {
  const MeshFile file = read("a.obj", "v .5 0 -.25\nv\t+.75 .5 0\r\nv 0 1. .125\nf 1 2 3\n");
  const Eigen::AlignedBox3f box = bounds(file);
  EXPECT_EQ(box.min(), Eigen::Vector3f(0, 0, -0.25F));
  EXPECT_EQ(box.max(), Eigen::Vector3f(0.75F, 1, 0.125F));
}

TEST_F(MeshRepair, ReadsObjAndItsLibraryWithMarksAndBlanks) {
  folder_.write("a.mtl", "\xEF\xBB\xBFnewmtl red  \nKd 1 0 0 \t\r\n");
  const MeshFile file =
      read("a.obj", "\xEF\xBB\xBFmtllib a.mtl \nusemtl red\t\n" + std::string(kTriangleObj));
  const MaterialSource& material = file.materials.at(file.parts.at(0).material);
  EXPECT_FALSE(material.is_default);
  EXPECT_EQ(material.material.diffuse, Eigen::Vector4f(1, 0, 0, 1));
  EXPECT_THAT(file.notes, IsEmpty());
}

TEST_F(MeshRepair, TellsSeveralLibrariesOnALineApart) {
  EXPECT_EQ(repairedObj("mtllib a.mtl my own.MTL  b.mtl\nv 0 0 0"),
            "mtllib a.mtl\nmtllib my own.MTL\nmtllib b.mtl\nv 0 0 0");
  EXPECT_EQ(librariesOfObj("mtllib a.mtl my own.mtl"),
            (std::vector<std::string>{"a.mtl", "my own.mtl"}));
}

TEST_F(MeshRepair, LeavesNamesThatBeginWithAPoint) {
  EXPECT_EQ(repairedObj("usemtl .5\nv .5 0 0"), "usemtl .5\nv 0.5 0 0");
  EXPECT_EQ(repairedObj("v 1.5 -1.5 .\n\n"), "v 1.5 -1.5 .\n\n");
}

TEST_F(MeshRepair, TakesIndicesOfWhatAFileDoesNotHaveFromItsFaces) {
  EXPECT_EQ(repairedObj("v 0 0 0\nvn 0 0 1\nf 1/2/1 2/3/1 3/4/1"),
            "v 0 0 0\nvn 0 0 1\nf 1//1 2//1 3//1");
  EXPECT_EQ(repairedObj("v 0 0 0\nf 1/2/1 2//1 3/4"), "v 0 0 0\nf 1 2 3");
  EXPECT_EQ(repairedObj("vt 0 0\nf 1/2 2/-3/5 3"), "vt 0 0\nf 1/2 2/-3 3");
  const std::string whole = "vt 0 0\nvn 0 0 1\nf 1/2/3 1//2 1/2";
  EXPECT_EQ(repairedObj(whole), whole);
}

TEST_F(MeshRepair, HasNoMaterialsWhereTheLibraryIsMissing) {
  const MeshFile file = read("a.obj", "mtllib gone.mtl\nusemtl red\n" + std::string(kTriangleObj));
  EXPECT_TRUE(file.materials.at(file.parts.at(0).material).is_default);
  EXPECT_THAT(file.notes, ElementsAre(HasSubstr("its material library 'gone.mtl' is not there")));
}

TEST_F(MeshRepair, RefusesALibraryThatIsAPipeAtOnce) {
  ASSERT_EQ(mkfifo((folder_ / "a.mtl").c_str(), 0600), 0);
  try {
    (void)read("a.obj", "mtllib a.mtl\nusemtl red\n" + std::string(kTriangleObj));
    FAIL() << "it is read";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("a.mtl', which is a pipe or a device")));
  }
}

/// glTF: a triangle with a picture, its numbers in another file.
std::string gltf(const std::string& buffer, const std::string& picture) {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
"materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
"textures": [{"source": 0}], "images": [{"uri": ")" +
         picture + R"("}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
"min": [0, 0, 0], "max": [1, 1, 1]}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
"buffers": [{"uri": ")" +
         buffer + R"(", "byteLength": 36}]})";
}

class GltfFiles : public MeshRepair {
 protected:
  GltfFiles() {
    for (const char* name : {"a.bin", "model/a.bin", "model/meshes/a.bin"}) {
      folder_.write(name, std::string(36, '\0'));
    }
  }
};

TEST_F(GltfFiles, MayNameFilesOfTheirModel) {
  EXPECT_THAT(read("model/meshes/a.gltf", gltf("a.bin", "a.png")).refusal, IsEmpty());
  folder_.write("model/model.config", "");
  EXPECT_THAT(read("model/meshes/a.gltf", gltf("../a.bin", "../textures/a.png")).refusal,
              IsEmpty());
}

TEST_F(GltfFiles, MayNameNoOthers) {
  EXPECT_THAT(read("model/meshes/a.gltf", gltf("../a.bin", "a.png")).refusal,
              HasSubstr("names the file '"));
  EXPECT_THAT(read("model/meshes/a.gltf", gltf("a.bin", "../../a.png")).refusal,
              HasSubstr("names the picture '../../a.png', which is not below"));
  EXPECT_THAT(read("model/meshes/a.gltf", gltf("a.bin", "%2e%2e/a.png")).refusal,
              HasSubstr("names the picture"));
  folder_.write("model/model.config", "");
  EXPECT_THAT(read("model/meshes/a.gltf", gltf("../../a.bin", "a.png")).refusal,
              HasSubstr("which is not below " + (folder_ / "model").string()));
}

TEST_F(MeshRepair, OfLinesNothingIsDrawnAndTheLoaderSaysSo) {
  std::string text = collada("<color>1 0 0 1</color>", "");
  const std::string end = "</mesh>";
  text.insert(text.find(end),
              "<lines count='1' material='M'><input semantic='VERTEX' source='#v' "
              "offset='0'/><p>0 1</p></lines>");
  const MeshFile file = read("edged.dae", text);
  EXPECT_TRUE(file.has_lines);
  ASSERT_EQ(file.parts.size(), 1U);
  EXPECT_EQ(file.parts[0].mesh.indices.size(), 3U);
  EXPECT_FALSE(read("plain.dae", collada("<color>1 0 0 1</color>", "")).has_lines);

  const ResourceFinder finder = test::finderIn(folder_);
  MeshLoader loader(finder);
  MeshRequest request;
  request.file = folder_ / "edged.dae";
  static_cast<void>(loader.pieces(request));
  EXPECT_THAT(loader.takeNotes(),
              ElementsAre(AllOf(HasSubstr("lines in meshes have no area, and are not drawn"),
                                HasSubstr("edged.dae'"))));
}

}  // namespace mesh_repair_test
}  // namespace synthetic_dataset::world

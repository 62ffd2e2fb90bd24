#include "world/mesh/skin_pose.h"

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"
#include "world/mesh/mesh_file.h"

namespace synthetic_dataset::world {
namespace skin_pose_test {

using test::TemporaryFolder;

/// A skin of one triangle from (0, 0, 0) to (1, 0, 0) and (0, 0, 1), whose last vertex hangs on the
/// bone "tip" at (0, 0, 1), the others on the bone "root" at the origin. The animation begins with
/// the tip at (0, 2, 1).
const std::string kSkin = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="1" name="meter"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g" name="g"><mesh>
<source id="g-p"><float_array id="g-pa" count="9">0 0 0 1 0 0 0 0 1</float_array><technique_common>
<accessor source="#g-pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="g-v"><input semantic="POSITION" source="#g-p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#g-v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_controllers><controller id="c"><skin source="#g">
<bind_shape_matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix>
<source id="c-j"><Name_array id="c-ja" count="2">root tip</Name_array><technique_common>
<accessor source="#c-ja" count="2" stride="1"><param name="JOINT" type="name"/></accessor></technique_common>
</source>
<source id="c-b"><float_array id="c-ba" count="32">1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1
1 0 0 0 0 1 0 0 0 0 1 -1 0 0 0 1</float_array><technique_common>
<accessor source="#c-ba" count="2" stride="16"><param name="TRANSFORM" type="float4x4"/></accessor>
</technique_common></source>
<source id="c-w"><float_array id="c-wa" count="1">1</float_array><technique_common>
<accessor source="#c-wa" count="1" stride="1"><param name="WEIGHT" type="float"/></accessor></technique_common>
</source>
<joints><input semantic="JOINT" source="#c-j"/><input semantic="INV_BIND_MATRIX" source="#c-b"/></joints>
<vertex_weights count="3"><input semantic="JOINT" source="#c-j" offset="0"/>
<input semantic="WEIGHT" source="#c-w" offset="1"/><vcount>1 1 1</vcount><v>0 0 0 0 1 0</v></vertex_weights>
</skin></controller></library_controllers>
<library_animations><animation id="a">
<source id="a-i"><float_array id="a-ia" count="2">0 1</float_array><technique_common>
<accessor source="#a-ia" count="2" stride="1"><param name="TIME" type="float"/></accessor></technique_common>
</source>
<source id="a-o"><float_array id="a-oa" count="32">1 0 0 0 0 1 0 2 0 0 1 1 0 0 0 1
1 0 0 0 0 1 0 3 0 0 1 1 0 0 0 1</float_array><technique_common>
<accessor source="#a-oa" count="2" stride="16"><param name="TRANSFORM" type="float4x4"/></accessor>
</technique_common></source>
<source id="a-n"><Name_array id="a-na" count="2">LINEAR LINEAR</Name_array><technique_common>
<accessor source="#a-na" count="2" stride="1"><param name="INTERPOLATION" type="name"/></accessor>
</technique_common></source>
<sampler id="a-s"><input semantic="INPUT" source="#a-i"/><input semantic="OUTPUT" source="#a-o"/>
<input semantic="INTERPOLATION" source="#a-n"/></sampler>
<channel source="#a-s" target="tip/matrix"/></animation></library_animations>
<library_visual_scenes><visual_scene id="s">
<node id="root" name="root" sid="root" type="JOINT"><matrix sid="matrix">1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>
<node id="tip" name="tip" sid="tip" type="JOINT"><matrix sid="matrix">1 0 0 0 0 1 0 0 0 0 1 1 0 0 0 1</matrix>
</node></node>
<node id="body" name="body"><instance_controller url="#c"><skeleton>#root</skeleton></instance_controller></node>
</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";

Eigen::Vector3f farthestOf(const MeshFile& file, int axis) {
  Eigen::Vector3f farthest = Eigen::Vector3f::Constant(-1.0F);
  for (const Eigen::Vector3f& position : file.parts.at(0).mesh.positions) {
    if (position[axis] > farthest[axis]) farthest = position;
  }
  return farthest;
}

TEST(SkinPose, IsAsModelledWithoutAnAnimation) {
  const TemporaryFolder folder;
  const MeshFile file = importMeshFile(folder.write("skin.dae", kSkin));
  EXPECT_TRUE(farthestOf(file, 2).isApprox(Eigen::Vector3f(0, 0, 1)));
}

TEST(SkinPose, IsTheAnimationsFirst) {
  const TemporaryFolder folder;
  const auto skin = folder.write("skin.dae", kSkin);
  const MeshFile file = importMeshFile(skin, folder.write("walk.dae", kSkin));
  EXPECT_TRUE(farthestOf(file, 1).isApprox(Eigen::Vector3f(0, 2, 1))) << "the tip has moved";
  EXPECT_TRUE(farthestOf(file, 0).isApprox(Eigen::Vector3f(1, 0, 0))) << "the root has not";
}

TEST(SkinPose, NeedsAnAnimationThatCanBeRead) {
  const TemporaryFolder folder;
  const auto skin = folder.write("skin.dae", kSkin);
  EXPECT_THROW(static_cast<void>(importMeshFile(skin, folder.write("walk.dae", "nothing"))), Error);
}

}  // namespace skin_pose_test
}  // namespace synthetic_dataset::world

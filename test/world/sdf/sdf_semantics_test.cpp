/// Which models are static, which move, and where they are, as defined by Gazebo Classic and the
/// versions of SDF.

#include <array>
#include <string>

#include <gmock/gmock.h>

#include "world/sdf/sdf_loader_support.h"
#include "world/world_loader.h"

namespace synthetic_dataset::world {
namespace sdf_semantics_test {

using namespace test;

bool isAt(const Pose& pose, double x, double y, double z) {
  return pose.translation().isApprox(Eigen::Vector3d(x, y, z), 1e-9);
}

TEST(SdfSemantics, ModelStandsWithAStaticModelInIt) {
  const TemporaryFolder folder;
  folder.write("ground.sdf", boxModel("ground", "<static>1</static>"));
  const Description world =
      loadText(folder, worldFile(modelElement("ground_001", includeElement("ground.sdf") +
                                                                "<pose>0 0 0.5 0 0 0</pose>")));
  EXPECT_TRUE(world.models.at(0).is_static);
}

TEST(SdfSemantics, IncludeMayMakeAStaticModelMove) {
  const TemporaryFolder folder;
  folder.write("crate.sdf", boxModel("crate", "<static>1</static>"));
  const Description world =
      loadText(folder, worldFile(includeElement("crate.sdf", "<static>false</static>")));
  EXPECT_FALSE(world.models.at(0).is_static);
}

TEST(SdfSemantics, ModelStandsThatAJointHoldsToTheWorld) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, worldFile(modelElement("door", linkElement() + "<joint name='hinge' type='revolute'>"
                                                             "<parent>world</parent><child>body"
                                                             "</child></joint>")));
  EXPECT_TRUE(world.models.at(0).is_static);
  EXPECT_THAT(world.notes, IsEmpty());
}

TEST(SdfSemantics, LinkMayHaveNoGravity) {
  const TemporaryFolder folder;
  const Description world =
      loadText(folder, worldFile(modelElement("m", linkElement("<gravity>false</gravity>"))));
  EXPECT_FALSE(world.models.at(0).links.at(0).has_gravity);
}

TEST(SdfSemantics, StatePlacesModelsLinksAndLights) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder,
      worldFile(modelElement("m", "<link name='a'/><link name='b'><pose>1 0 0 0 0 0</pose></link>" +
                                      modelElement("arm", "<link name='c'/>")) +
                "<light name='l' type='point'/><state world_name='w'><model name='m'>"
                "<pose>1 2 3 0 0 0</pose><link name='b'><pose>5 5 5 0 0 0</pose></link>"
                "<model name='arm'><link name='c'><pose>7 7 7 0 0 0</pose></link></model></model>"
                "<light name='l'><pose>4 5 6 0 0 0</pose></light></state>"));
  const Model& model = world.models.at(0);
  EXPECT_TRUE(isAt(model.X_WM * model.links.at(0).X_ML, 1, 2, 3));
  EXPECT_TRUE(isAt(model.X_WM * model.links.at(1).X_ML, 5, 5, 5));
  EXPECT_TRUE(isAt(model.X_WM * model.links.at(2).X_ML, 7, 7, 7));
  EXPECT_TRUE(isAt(world.lights.at(0).X_WL, 4, 5, 6));
}

TEST(SdfSemantics, StateScalesShapesAndNotPoses) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder,
      worldFile(
          modelElement("m", linkElement("<collision name='c'><pose>1 0 0 0 0 0</pose><geometry>"
                                        "<cylinder><radius>1</radius><length>1</length>"
                                        "</cylinder></geometry></collision>")) +
          "<state world_name='w'><model name='m'><scale>2 3 4</scale></model></state>"));
  const Collision& collision = world.models.at(0).links.at(0).collisions.at(0);
  EXPECT_TRUE(isAt(collision.X_LC, 1, 0, 0));
  EXPECT_EQ(std::get<CylinderShape>(collision.shape).radius, 3.0);
  EXPECT_EQ(std::get<CylinderShape>(collision.shape).length, 4.0);
}

TEST(SdfSemantics, StateInsertsAndDeletes) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, worldFile(modelElement("old", linkElement()) + "<state world_name='w'><insertions>" +
                        modelElement("new", linkElement()) +
                        "</insertions><deletions><name>old</name></deletions></state>"));
  ASSERT_THAT(world.models, SizeIs(1));
  EXPECT_EQ(world.models[0].name, "new");
}

TEST(SdfSemantics, PosesMayBeInDegreesOrQuaternions) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, "<sdf version='1.9'><world name='w'>" +
                  modelElement("a", "<pose degrees='true'>1 2 3 0 0 90</pose>" + linkElement()) +
                  modelElement("b",
                               "<pose rotation_format='quat_xyzw'>1 2 3  0 0 0.70710678118654752 "
                               "0.70710678118654752</pose>" +
                                   linkElement()) +
                  "</world></sdf>");
  const Eigen::Matrix3d quarter =
      Eigen::AngleAxisd(M_PI / 2.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  for (const Model& model : world.models) {
    EXPECT_TRUE(isAt(model.X_WM, 1, 2, 3));
    EXPECT_TRUE(model.X_WM.linear().isApprox(quarter, 1e-12)) << model.name;
  }
}

TEST(SdfSemantics, FramesMayBeAttachedToOthers) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, worldFile(modelElement("m",
                                     "<link name='a'><pose>1 0 0 0 0 0</pose></link>"
                                     "<frame name='f' attached_to='a'><pose>0 1 0 0 0 0</pose>"
                                     "</frame><link name='b'><pose relative_to='f'>0 0 1 0 0 0"
                                     "</pose></link>"
                                     "<joint name='j' type='fixed'><parent>f</parent>"
                                     "<child>b</child></joint>")));
  const Model& model = world.models.at(0);
  EXPECT_TRUE(isAt(model.links.at(1).X_ML, 1, 1, 1));
  EXPECT_EQ(model.links.at(1).parent, 0U);
}

TEST(SdfSemantics, ModelsMayBePlacedByNamesInOthers) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, worldFile(modelElement("table",
                                     "<pose>1 0 0 0 0 0</pose><link name='top'><pose>0 0 2 0 0 0"
                                     "</pose></link>") +
                        modelElement("cup", "<pose relative_to='table::top'>0 3 0 0 0 0</pose>" +
                                                linkElement())));
  EXPECT_TRUE(isAt(world.models.at(1).X_WM, 1, 3, 2));
}

TEST(SdfSemantics, GravityMayBeOfPhysics) {
  const TemporaryFolder folder;
  EXPECT_EQ(loadText(folder,
                     "<sdf version='1.4'><world name='w'><physics type='ode'><gravity>0 0 -1"
                     "</gravity></physics></world></sdf>")
                .gravity,
            Eigen::Vector3d(0, 0, -1));
}

TEST(SdfSemantics, OldestVersionHasAttributesForValues) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder,
      "<gazebo version='1.0'><world name='w'><scene><ambient rgba='0.1 0.2 0.3 1'/></scene>"
      "<physics type='ode'><gravity xyz='0 0 -2'/></physics>"
      "<model name='m' static='1'><origin pose='1 2 3 0 0 0'/><link name='a'>"
      "<origin pose='0 0 1 0 0 0'/><inertial mass='2'><inertia ixx='1' ixy='0' ixz='0' iyy='1' "
      "iyz='0' izz='1'/></inertial>"
      "<visual name='v' cast_shadows='0'><origin pose='0 1 0 0 0 0'/><geometry><box size='1 2 3'/>"
      "</geometry><material script='Gazebo/Red'/></visual>"
      "<collision name='c'><geometry><cylinder radius='2' length='3'/></geometry></collision>"
      "</link><link name='b'/><joint name='j' type='revolute'><parent link='a'/><child link='b'/>"
      "</joint></model><light name='l' type='point' cast_shadows='1'><origin pose='0 0 9 0 0 0'/>"
      "<diffuse rgba='0.5 0.6 0.7 1'/><attenuation range='7' linear='0.1' constant='0.2' "
      "quadratic='0.3'/></light></world></gazebo>");
  EXPECT_TRUE(world.ambient.isApprox(Eigen::Vector3f(0.1F, 0.2F, 0.3F)));
  EXPECT_EQ(world.gravity, Eigen::Vector3d(0, 0, -2));
  const Model& model = world.models.at(0);
  EXPECT_TRUE(model.is_static);
  EXPECT_TRUE(isAt(model.X_WM, 1, 2, 3));
  EXPECT_TRUE(isAt(model.links.at(0).X_ML, 0, 0, 1));
  EXPECT_EQ(model.links.at(1).parent, 0U);
  const Visual& visual = model.links.at(0).visuals.at(0);
  EXPECT_TRUE(isAt(visual.X_LV, 0, 1, 0));
  EXPECT_FALSE(visual.casts_shadow);
  EXPECT_EQ(std::get<CylinderShape>(model.links.at(0).collisions.at(0).shape).radius, 2.0);
  const Light& light = world.lights.at(0);
  EXPECT_TRUE(light.casts_shadow);
  EXPECT_TRUE(light.diffuse.isApprox(Eigen::Vector3f(0.5F, 0.6F, 0.7F)));
  EXPECT_DOUBLE_EQ(light.range, 7.0);
  EXPECT_THAT(world.notes, IsEmpty());
}

TEST(SdfSemantics, RoadIsAStripAlongItsPoints) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, worldFile("<road name='r'><width>2</width><point>0 0 0</point><point>4 0 0</point>"
                        "<point>4 4 0</point></road>"));
  const Mesh& mesh = *world.models.at(0).links.at(0).visuals.at(0).surfaces.at(0).mesh;
  ASSERT_THAT(mesh.positions, SizeIs(6));
  EXPECT_TRUE(mesh.positions[0].isApprox(Eigen::Vector3f(0, 1, 0)));
  EXPECT_TRUE(mesh.positions[2].isApprox(Eigen::Vector3f(3, 1, 0), 1e-5F)) << "the bend's inside";
  EXPECT_TRUE(mesh.positions[3].isApprox(Eigen::Vector3f(5, -1, 0), 1e-5F));
  EXPECT_TRUE(mesh.positions[5].isApprox(Eigen::Vector3f(5, 4, 0)));
  const Eigen::Vector3f normal =
      (mesh.positions[mesh.indices[1]] - mesh.positions[mesh.indices[0]])
          .cross(mesh.positions[mesh.indices[2]] - mesh.positions[mesh.indices[0]]);
  EXPECT_GT(normal.z(), 0.0F) << "seen from above";
}

TEST(SdfSemantics, UrdfMayBeIncludedInAModel) {
  const TemporaryFolder folder;
  folder.write("arm.urdf",
               "<robot name='arm'><link name='base'/><link name='hand'/><joint name='j' "
               "type='fixed'><parent link='base'/><child link='hand'/><origin xyz='0 0 1'/></joint>"
               "</robot>");
  const Description world = loadText(
      folder,
      worldFile(modelElement(
          "robot", linkElement() + includeElement("arm.urdf", "<pose>1 0 0 0 0 0</pose>"))));
  const Model& robot = world.models.at(0);
  ASSERT_THAT(robot.links, SizeIs(3));
  EXPECT_EQ(robot.links[2].name, "arm::hand");
  EXPECT_EQ(robot.links[2].parent, 1U);
  EXPECT_TRUE(isAt(robot.links[2].X_ML, 1, 0, 1));
}

std::string population(const std::string& content) {
  return "<population name='crates'>" +
         modelElement("crate", "<pose>9 9 9 0 0 1</pose>" + linkElement(visualElement(kBox))) +
         content + "</population>";
}

TEST(SdfSemantics, PopulationStandsInRowsAndColumnsAroundItsPose) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, worldFile(population("<pose>1 2 3 0 0 0</pose><distribution><type>grid</type><rows>2"
                                   "</rows><cols>3</cols><step>0.5 0.4 0</step></distribution>")));
  ASSERT_THAT(world.models, SizeIs(6));
  EXPECT_EQ(world.models[5].name, "crate_clone_5");
  EXPECT_TRUE(isAt(world.models[0].X_WM, 0.5, 1.8, 3.0));
  EXPECT_TRUE(isAt(world.models[1].X_WM, 1.0, 1.8, 3.0));
  EXPECT_TRUE(isAt(world.models[5].X_WM, 1.5, 2.2, 3.0));
  EXPECT_TRUE(world.models[0].X_WM.linear().isIdentity()) << "not the model's own pose";
}

TEST(SdfSemantics, PopulationStandsInALine) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, worldFile(population("<pose>0 4 0 0 0 0</pose><box><size>2 1 0.5</size></box>"
                                   "<model_count>4</model_count><distribution><type>"
                                   "linear-x</type></distribution>")));
  ASSERT_THAT(world.models, SizeIs(4));
  EXPECT_TRUE(isAt(world.models[0].X_WM, -1.0, 4.0, 0.0));
  EXPECT_TRUE(isAt(world.models[3].X_WM, 0.5, 4.0, 0.0));
}

TEST(SdfSemantics, PopulationAtRandomIsInItsRegionAndTheSameAgain) {
  const TemporaryFolder folder;
  for (const std::string type : {"random", "uniform"}) {
    const std::string text = worldFile(
        population("<pose>3 3 1 0 0 0</pose><cylinder><radius>2</radius><length>0.5</length>"
                   "</cylinder><model_count>50</model_count><distribution><type>" +
                   type + "</type></distribution>"));
    const Description world = loadText(folder, text);
    const Description again = loadText(folder, text);
    ASSERT_THAT(world.models, SizeIs(50));
    std::array<int, 4> quarters{};
    for (std::size_t i = 0; i < 50; ++i) {
      const Eigen::Vector3d p = world.models[i].X_WM.translation() - Eigen::Vector3d(3, 3, 1);
      EXPECT_LE(p.head<2>().norm(), 2.0);
      EXPECT_GE(p.z(), 0.0);
      EXPECT_LE(p.z(), 0.5);
      EXPECT_EQ(world.models[i].X_WM.translation(), again.models[i].X_WM.translation());
      ++quarters[(p.x() > 0 ? 1U : 0U) + (p.y() > 0 ? 2U : 0U)];
    }
    for (const int count : quarters) EXPECT_GE(count, 5) << type;
  }
}

TEST(SdfSemantics, PopulationThatSaysTooLittleIsLeftOutWithANote) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, worldFile(population("<box><size>1 1 1</size></box><model_count>0</model_count>"
                                   "<distribution><type>random</type></distribution>") +
                        population("<model_count>3</model_count>"
                                   "<distribution><type>random</type></distribution>")));
  EXPECT_THAT(world.models, IsEmpty());
  EXPECT_THAT(world.notes, ElementsAre(HasSubstr("model_count: found 0"),
                                       HasSubstr("no <box> and no <cylinder>")));
}

TEST(SdfSemantics, ActorStandsAtItsFirstWaypoint) {
  const TemporaryFolder folder;
  folder.write("person.obj", test::kTriangleObj);
  const Description world = loadText(
      folder,
      worldFile("<actor name='ann'><pose>9 9 9 0 0 0</pose><skin><filename>person.obj</filename>"
                "<scale>2</scale></skin><script><trajectory id='0' type='walking'><waypoint>"
                "<time>0</time><pose>1 2 0 0 0 0</pose></waypoint></trajectory></script></actor>"
                "<actor name='bob'><pose>3 0 0 0 0 0</pose><skin><filename>person.obj</filename>"
                "</skin></actor>"));
  ASSERT_THAT(world.models, SizeIs(2));
  EXPECT_TRUE(world.models[0].is_static);
  EXPECT_TRUE(isAt(world.models[0].X_WM, 1, 2, 0));
  EXPECT_TRUE(isAt(world.models[1].X_WM, 3, 0, 0));
  const Mesh& mesh = *world.models[0].links.at(0).visuals.at(0).surfaces.at(0).mesh;
  EXPECT_EQ(mesh.positions.at(2), Eigen::Vector3f(0, 4, 0)) << "twice as large";
  EXPECT_THAT(world.notes, IsEmpty());
}

}  // namespace sdf_semantics_test
}  // namespace synthetic_dataset::world

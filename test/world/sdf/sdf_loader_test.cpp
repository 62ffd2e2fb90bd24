#include "world/world_loader.h"

#include <Eigen/Geometry>

#include <gmock/gmock.h>

#include "world/sdf/sdf_loader_support.h"

namespace synthetic_dataset::world {
namespace sdf_loader_test {

using namespace test;

constexpr double kQuarter = 1.57079632679489662;

testing::AssertionResult isAt(const Pose& pose, double x, double y, double z, double yaw) {
  const Pose expected =
      makePose({x, y, z}, Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ())));
  if (pose.matrix().isApprox(expected.matrix(), 1e-9)) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "found\n" << pose.matrix();
}

TEST(SdfLoader, ReadsAWorld) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, worldFile("<gravity>0 0 -1.6</gravity><scene><ambient>0.1 0.2 0.3 1</ambient>"
                        "<background>0.4 0.5 0.6 1</background></scene>" +
                        modelElement("m", "<static>true</static><pose>1 2 3 0 0 0</pose>" +
                                              linkElement(visualElement(kBox)))));
  EXPECT_EQ(world.gravity, Eigen::Vector3d(0, 0, -1.6));
  EXPECT_TRUE(world.ambient.isApprox(Eigen::Vector3f(0.1F, 0.2F, 0.3F)));
  EXPECT_TRUE(world.background.isApprox(Eigen::Vector3f(0.4F, 0.5F, 0.6F)));
  ASSERT_THAT(world.models, SizeIs(1));
  EXPECT_TRUE(world.models[0].is_static);
  EXPECT_TRUE(isAt(world.models[0].X_WM, 1, 2, 3, 0));
  EXPECT_THAT(world.notes, IsEmpty());
}

TEST(SdfLoader, ReadsAModelFileAsAWorld) {
  const TemporaryFolder folder;
  const Description world = loadText(folder, boxModel("m", "<pose>1 0 0 0 0 0</pose>"));
  ASSERT_THAT(world.models, SizeIs(1));
  EXPECT_TRUE(isAt(world.models[0].X_WM, 1, 0, 0, 0));
}

TEST(SdfLoader, TakesTheBestFileOfAModelFolder) {
  const TemporaryFolder folder;
  folder.write("crate/model.config",
               "<model><name>Crate</name><sdf version='1.4'>old.sdf</sdf>"
               "<sdf version='1.6'>new.sdf</sdf><sdf version='99.0'>future.sdf</sdf></model>");
  folder.write("crate/old.sdf", boxModel("old"));
  folder.write("crate/new.sdf", boxModel("new"));
  folder.write("crate/future.sdf", boxModel("future"));
  const ResourceFinder finder = test::finderIn(folder);
  EXPECT_EQ(loadWorld("model://crate", finder).models[0].name, "new");
}

TEST(SdfLoader, NamesAModelAsAsked) {
  const TemporaryFolder folder;
  const auto file = folder.write("crate.sdf", boxModel("crate"));
  EXPECT_EQ(loadModel(file.string(), "alpha", test::finderIn(folder)).name, "alpha");
}

TEST(SdfLoader, OverridesWhatAnIncludeSays) {
  const TemporaryFolder folder;
  folder.write("crate.sdf", boxModel("crate", "<pose>9 9 9 0 0 0</pose>"));
  const Description world = loadText(
      folder, worldFile(includeElement("crate.sdf",
                                       "<name>big</name><pose>1 2 3 0 0 1.57079632679</pose>"
                                       "<static>true</static>")));
  ASSERT_THAT(world.models, SizeIs(1));
  EXPECT_EQ(world.models[0].name, "big");
  EXPECT_TRUE(world.models[0].is_static);
  EXPECT_TRUE(isAt(world.models[0].X_WM, 1, 2, 3, 1.57079632679));
}

TEST(SdfLoader, FlattensNestedModels) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder,
      worldFile(modelElement(
          "robot",
          "<pose>1 2 3 0 0 1.57079632679489662</pose><link name='base'><pose>1 0 0 0 0 0</pose>"
          "</link><model name='arm'><pose>0 1 0 0 0 1.57079632679489662</pose>"
          "<link name='wrist'><pose>1 0 0 0 0 0</pose>"
          "<visual name='v'><pose>0 0 0.5 0 0 0</pose><geometry><sphere><radius>1</radius></sphere>"
          "</geometry></visual></link></model>")));
  const Model& robot = world.models.at(0);
  ASSERT_THAT(robot.links, SizeIs(2));
  EXPECT_EQ(robot.links[0].name, "base");
  EXPECT_EQ(robot.links[1].name, "arm::wrist");
  EXPECT_TRUE(isAt(robot.links[0].X_ML, 1, 0, 0, 0));
  EXPECT_TRUE(isAt(robot.links[1].X_ML, 0, 2, 0, kQuarter));
  EXPECT_TRUE(isAt(robot.X_WM * robot.links[1].X_ML, -1, 2, 3, 2.0 * kQuarter));
  EXPECT_TRUE(isAt(robot.links[1].visuals.at(0).X_LV, 0, 0, 0.5, 0));
}

TEST(SdfLoader, FlattensIncludedModels) {
  const TemporaryFolder folder;
  folder.write("parts/wheel.sdf", boxModel("wheel"));
  folder.write("cart.sdf", modelFile("cart", "<link name='base'/>" +
                                                 includeElement("parts/wheel.sdf",
                                                                "<name>left</name>"
                                                                "<pose>0 1 0 0 0 0</pose>")));
  const Description world =
      loadText(folder, worldFile(includeElement("cart.sdf", "<pose>5 0 0 0 0 0</pose>")));
  const Model& cart = world.models.at(0);
  ASSERT_THAT(cart.links, SizeIs(2));
  EXPECT_EQ(cart.links[1].name, "left::body");
  EXPECT_TRUE(isAt(cart.links[1].X_ML, 0, 1, 0, 0));
}

TEST(SdfLoader, TakesRelativeIncludesFromTheFileThatNamesThem) {
  const TemporaryFolder folder;
  for (const std::string name : {"a", "b"}) {
    folder.write(name + "/part.sdf", boxModel("part_of_" + name));
    folder.write(name + "/whole.sdf",
                 modelFile("whole_" + name, "<link name='base'/>" + includeElement("part.sdf")));
  }
  const Description world =
      loadText(folder, worldFile(includeElement("a/whole.sdf") + includeElement("b/whole.sdf")));
  EXPECT_EQ(world.models.at(0).links.at(1).name, "part_of_a::body");
  EXPECT_EQ(world.models.at(1).links.at(1).name, "part_of_b::body");
}

TEST(SdfLoader, ResolvesPosesInOtherFrames) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder,
      worldFile("<frame name='table_top'><pose>0 0 1 0 0 1.57079632679489662</pose></frame>" +
                modelElement("cup",
                             "<pose relative_to='table_top'>1 0 0 0 0 0</pose>"
                             "<link name='body'/>"
                             "<link name='lid'><pose relative_to='hinge'>0 0 2 0 0 0</pose>"
                             "</link><link name='pin'><pose>3 0 0 0 0 0</pose></link>"
                             "<joint name='hinge' type='fixed'><pose>0 4 0 0 0 0</pose>"
                             "<parent>body</parent><child>pin</child></joint>")));
  const Model& cup = world.models.at(0);
  EXPECT_TRUE(isAt(cup.X_WM, 0, 1, 1, kQuarter));
  EXPECT_TRUE(isAt(cup.links.at(1).X_ML, 3, 4, 2, 0));  // the joint's pose is in its child's frame
}

TEST(SdfLoader, PutsModelsWhereASavedWorldsStateHasThem) {
  const TemporaryFolder folder;
  const Description world =
      loadText(folder, worldFile(modelElement("m", linkElement()) +
                                 "<state world_name='w'><model name='m'>"
                                 "<pose>1 2 3 0 0 1.57079632679489662</pose></model></state>"));
  EXPECT_TRUE(isAt(world.models.at(0).X_WM, 1, 2, 3, kQuarter));
}

TEST(SdfLoader, ReadsInertia) {
  const TemporaryFolder folder;
  // After a quarter turn about z, the moments about x and y are swapped.
  const Description world = loadText(
      folder, worldFile(modelElement(
                  "m", linkElement("<inertial><pose>0.1 0.2 0.3 0 0 1.57079632679489662</pose>"
                                   "<mass>2</mass><inertia><ixx>1</ixx><iyy>2</iyy><izz>2.5</izz>"
                                   "</inertia></inertial>"))));
  const auto& inertia = world.models.at(0).links.at(0).inertia;
  ASSERT_TRUE(inertia);
  EXPECT_DOUBLE_EQ(inertia->mass, 2.0);
  EXPECT_TRUE(inertia->centre_of_mass_L.isApprox(Eigen::Vector3d(0.1, 0.2, 0.3)));
  EXPECT_TRUE(
      inertia->moments_L.isApprox(Eigen::Matrix3d(Eigen::Vector3d(2, 1, 2.5).asDiagonal()), 1e-9));
}

TEST(SdfLoader, ReplacesImpossibleInertiaWithANote) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, worldFile(modelElement("m", linkElement("<inertial><mass>-1</mass></inertial>"))));
  EXPECT_FALSE(world.models.at(0).links.at(0).inertia);
  EXPECT_THAT(world.notes, ElementsAre(HasSubstr("model 'm': link 'body': its <inertial>")));
}

TEST(SdfLoader, ReadsCollisions) {
  const TemporaryFolder folder;
  const auto collision = [](const std::string& name, const std::string& geometry) {
    return "<collision name='" + name + "'><geometry>" + geometry + "</geometry></collision>";
  };
  const Description world = loadText(
      folder,
      worldFile(modelElement(
          "m",
          linkElement(
              "<collision name='a'><pose>0 0 1 0 0 0</pose><geometry>" + std::string(kBox) +
              "</geometry><surface><bounce><restitution_coefficient>0.5</restitution_coefficient>"
              "</bounce><friction><ode><mu>0.25</mu></ode></friction></surface></collision>" +
              collision("b", "<cylinder><radius>1</radius><length>2</length></cylinder>") +
              collision("c", "<plane><normal>0 1 0</normal></plane>")))));
  const std::vector<Collision>& collisions = world.models.at(0).links.at(0).collisions;
  ASSERT_THAT(collisions, SizeIs(3));
  EXPECT_TRUE(isAt(collisions[0].X_LC, 0, 0, 1, 0));
  EXPECT_EQ(std::get<BoxShape>(collisions[0].shape).size, Eigen::Vector3d(1, 2, 3));
  EXPECT_DOUBLE_EQ(collisions[0].friction, 0.25);
  EXPECT_DOUBLE_EQ(collisions[0].restitution, 0.5);
  EXPECT_DOUBLE_EQ(std::get<CylinderShape>(collisions[1].shape).length, 2.0);
  EXPECT_DOUBLE_EQ(collisions[1].friction, 1.0);
  EXPECT_EQ(std::get<PlaneShape>(collisions[2].shape).normal, Eigen::Vector3d(0, 1, 0));
}

TEST(SdfLoader, HangsLinksOnTheParentsOfTheirJoints) {
  const TemporaryFolder folder;
  const std::string joints =
      "<link name='a'/><link name='b'/><link name='c'/>"
      "<joint name='knee' type='revolute'><parent>a</parent><child>b</child>"
      "<axis><xyz>0 0 1</xyz></axis></joint>"
      "<joint name='weld' type='fixed'><parent>a</parent><child>c</child></joint>";
  const std::vector<Link> links =
      loadText(folder, worldFile(modelElement("m", joints))).models.at(0).links;
  ASSERT_THAT(links, SizeIs(3));
  EXPECT_EQ(links[0].parent, std::nullopt);
  EXPECT_EQ(links[1].parent, 0U);
  EXPECT_EQ(links[2].parent, 0U);
  EXPECT_EQ(links[1].moving_joint, "knee");
  EXPECT_EQ(links[2].moving_joint, "");
}

TEST(SdfLoader, HangsLinksOfNestedModelsOnTheirParents) {
  const TemporaryFolder folder;
  const std::string model =
      "<link name='base'/><joint name='mount' type='fixed'><parent>base</parent>"
      "<child>arm::upper</child></joint>"
      "<joint name='ground' type='fixed'><parent>world</parent><child>base</child></joint>" +
      modelElement("arm",
                   "<link name='upper'/><link name='wrist'/><joint name='turn' type='revolute'>"
                   "<parent>upper</parent><child>wrist</child><axis><xyz>0 0 1</xyz></axis>"
                   "</joint>");
  const std::vector<Link> links =
      loadText(folder, worldFile(modelElement("m", model))).models.at(0).links;
  ASSERT_THAT(links, SizeIs(3));
  EXPECT_EQ(links[0].parent, std::nullopt);
  EXPECT_EQ(links[1].parent, 0U);
  EXPECT_EQ(links[2].name, "arm::wrist");
  EXPECT_EQ(links[2].parent, 1U);
  EXPECT_EQ(links[2].moving_joint, "arm::turn");
}

TEST(SdfLoader, NotesWhatIsLeftOut) {
  const TemporaryFolder folder;
  const Description world =
      loadText(folder, worldFile(modelElement("m", linkElement(visualElement("<cone/>")))));
  EXPECT_THAT(world.models.at(0).links.at(0).visuals, IsEmpty());
  EXPECT_THAT(world.notes, ElementsAre(HasSubstr("visual 'v': its geometry, a 'cone', is")));
}

TEST(SdfLoader, KeepsNotesOfModels) {
  const TemporaryFolder folder;
  const auto file = folder.write("m.sdf", modelFile("m", linkElement(visualElement("<cone/>"))));
  const ResourceFinder finder = test::finderIn(folder);
  WorldLoader loader(finder);
  static_cast<void>(loader.loadModel(file.string(), "alpha"));
  EXPECT_THAT(loader.modelNotes(), ElementsAre(testing::HasSubstr("alpha: ")));
}

}  // namespace sdf_loader_test
}  // namespace synthetic_dataset::world

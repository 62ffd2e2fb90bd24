/// Files that Gazebo opens although something in them is wrong.

#include <gmock/gmock.h>

#include "world/sdf/sdf_loader_support.h"
#include "world/world_loader.h"

namespace synthetic_dataset::world {
namespace sdf_leniency_test {

using namespace test;

std::vector<std::string> linkNames(const Model& model) {
  std::vector<std::string> names;
  for (const Link& link : model.links) names.push_back(link.name);
  return names;
}

TEST(LenientSdf, HasTwoModelsOfOneName) {
  const TemporaryFolder folder;
  const std::string model = modelElement("m", linkElement(visualElement(kBox)));
  const Description world = loadText(folder, worldFile(model + "\n" + model));
  ASSERT_THAT(world.models, SizeIs(2));
  EXPECT_EQ(world.models[0].name, "m");
  EXPECT_EQ(world.models[1].name, "m_1");
  EXPECT_THAT(world.notes, ElementsAre(AllOf(HasSubstr("world.sdf: line 2: model 'm'"),
                                             HasSubstr("it is called 'm_1' here"))));
}

TEST(LenientSdf, HasALightAndAModelOfOneName) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, worldFile(modelElement("sun", "<pose>9 9 9 0 0 0</pose>" + linkElement()) +
                        "<light name='sun' type='point'><pose>1 2 3 0 0 0</pose></light>"));
  EXPECT_TRUE(world.lights.at(0).X_WL.translation().isApprox(Eigen::Vector3d(1, 2, 3)));
  EXPECT_THAT(world.notes, IsEmpty());
}

TEST(LenientSdf, HasNamesThatAreReserved) {
  const TemporaryFolder folder;
  const Description world =
      loadText(folder,
               "<sdf version='1.6'><world name='world'><model name='m'><link name='ten::link'>"
               "<pose>1 0 0 0 0 0</pose></link><link name='world'/></model></world></sdf>");
  EXPECT_THAT(linkNames(world.models.at(0)), ElementsAre("ten::link", "world"));
  EXPECT_TRUE(world.models[0].links[0].X_ML.translation().isApprox(Eigen::Vector3d(1, 0, 0)));
}

TEST(LenientSdf, HasAJointWithoutItsLink) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder,
      worldFile(modelElement("m", linkElement() + "<joint name='j' type='fixed'><parent>body"
                                                  "</parent><child>gone</child></joint>")));
  EXPECT_THAT(linkNames(world.models.at(0)), ElementsAre("body"));
  EXPECT_THAT(world.notes, ElementsAre(HasSubstr("joint 'j': found 'gone', which is not a link of "
                                                 "the model; the joint is left out")));
}

TEST(LenientSdf, HasAPoseRelativeToAnUnknownFrame) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, worldFile(modelElement("m",
                                     "<link name='a'><pose relative_to='gone'>1 2 3 0 0 0</pose>"
                                     "</link>")));
  EXPECT_TRUE(world.models.at(0).links.at(0).X_ML.translation().isApprox(Eigen::Vector3d(1, 2, 3)));
  EXPECT_THAT(world.notes,
              ElementsAre(HasSubstr("link 'a': its pose is relative to 'gone', which is "
                                    "not known here")));
}

TEST(LenientSdf, HasPosesThatRunInACircle) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder,
      worldFile(modelElement("m",
                             "<link name='a'><pose relative_to='b'>1 0 0 0 0 0</pose></link>"
                             "<link name='b'><pose relative_to='a'>0 1 0 0 0 0</pose>"
                             "</link>")));
  EXPECT_THAT(world.notes, Contains(HasSubstr("relative to itself, through others")));
}

TEST(LenientSdf, HasColoursBeyondOne) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, worldFile(modelElement(
                  "m", linkElement(visualElement(kBox,
                                                 "<material><diffuse>127 127 127 255</diffuse>"
                                                 "</material>")))));
  const Material& material = world.models.at(0).links.at(0).visuals.at(0).surfaces.at(0).material;
  EXPECT_EQ(material.diffuse, Eigen::Vector4f(1, 1, 1, 1));
  EXPECT_THAT(world.notes, ElementsAre(HasSubstr("diffuse: found '127 127 127 255'; colours are 0 "
                                                 "to 1")));
}

TEST(LenientSdf, HasNumbersThatRunTogether) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, worldFile(modelElement("m", "<pose>0.09 1.6-0.19 0 -0 0</pose>" + linkElement())));
  EXPECT_TRUE(world.models.at(0).X_WM.translation().isApprox(Eigen::Vector3d(0.09, 1.6, -0.19)));
  EXPECT_THAT(world.notes, IsEmpty());
}

TEST(LenientSdf, HasNegativeFriction) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder,
      worldFile(modelElement(
          "m",
          linkElement("<collision name='c'><geometry>" + std::string(kBox) +
                      "</geometry><surface><friction><ode><mu>-1</mu></ode></friction></surface>"
                      "</collision>"))));
  EXPECT_EQ(world.models.at(0).links.at(0).collisions.at(0).friction, 1.0);
  EXPECT_THAT(world.notes, ElementsAre(HasSubstr("collision 'c': friction mu: found -1")));
}

TEST(LenientSdf, HasAnEmptyMaterialScript) {
  const TemporaryFolder folder;
  EXPECT_THAT(
      notesOf(folder, worldFile(modelElement("m", linkElement(visualElement(
                                                      kBox, "<material><script/></material>"))))),
      IsEmpty());
}

TEST(LenientSdf, HasTransparencyBeyondItsRange) {
  const TemporaryFolder folder;
  const auto world = [&](const std::string& transparency) {
    return loadText(folder, worldFile(modelElement("m", linkElement(visualElement(
                                                            kBox, "<transparency>" + transparency +
                                                                      "</transparency>")))));
  };
  EXPECT_THAT(world("-7").models.at(0).links.at(0).visuals, SizeIs(1));
  EXPECT_THAT(world("7").models.at(0).links.at(0).visuals, IsEmpty());
  EXPECT_THAT(world("7").notes,
              ElementsAre(HasSubstr("transparency: found 7; it should be 0 to 1")));
}

}  // namespace sdf_leniency_test
}  // namespace synthetic_dataset::world

/// The numbers that gz-sim's label plugin gives to models and visuals.

#include <gmock/gmock.h>

#include "world/sdf/sdf_loader_support.h"
#include "world/world_loader.h"

namespace synthetic_dataset::world {
namespace sdf_labels_test {

using namespace test;

std::string labelPlugin(int label) {
  return "<plugin filename='gz-sim-label-system' name='gz::sim::systems::Label'><label>" +
         std::to_string(label) + "</label></plugin>";
}

TEST(SdfLabels, AreThoseOfModelsAndOfModelsInThem) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, worldFile(modelElement("house", linkElement(visualElement(kBox)) + labelPlugin(3) +
                                                  modelElement("roof", linkElement())) +
                        modelElement("tree", linkElement())));
  EXPECT_EQ(world.models.at(0).links.at(0).label, 3);
  EXPECT_EQ(world.models.at(0).links.at(1).label, 3);
  EXPECT_EQ(world.models.at(1).links.at(0).label, std::nullopt);
}

TEST(SdfLabels, MayBeGivenToAVisual) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, worldFile(modelElement(
                  "house", labelPlugin(3) + linkElement(visualElement(kBox, labelPlugin(4))))));
  EXPECT_EQ(world.models.at(0).links.at(0).label, 4);
}

TEST(SdfLabels, MayStandInAnInclude) {
  const TemporaryFolder folder;
  folder.write("crate.sdf", boxModel("crate", labelPlugin(3)));
  const Description world =
      loadText(folder, worldFile(includeElement("crate.sdf", labelPlugin(5))));
  EXPECT_EQ(world.models.at(0).links.at(0).label, 5);
}

TEST(SdfLabels, AreKnownByTheOlderNamesOfTheSimulatorToo) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder,
      worldFile(modelElement("tree", linkElement() +
                                         "<plugin filename='ignition-gazebo-label-system' "
                                         "name='ignition::gazebo::systems::Label'><label>12"
                                         "</label></plugin>") +
                modelElement("bush", linkElement() + "<plugin filename='libgrow.so' name='grow'>"
                                                     "<label>9</label></plugin>")));
  EXPECT_EQ(world.models.at(0).links.at(0).label, 12);
  EXPECT_EQ(world.models.at(1).links.at(0).label, std::nullopt);
}

}  // namespace sdf_labels_test
}  // namespace synthetic_dataset::world

#include <string>

#include <gtest/gtest.h>

#include "support/temporary_folder.h"
#include "world/sdf/sdf_loader_support.h"

namespace synthetic_dataset::world {
namespace {

using test::TemporaryFolder;

Simulator simulatorOf(const std::string& text, const LoadOptions& options = {}) {
  const TemporaryFolder folder;
  const std::string file = folder.write("world.sdf", text).string();
  return loadWorld(file, test::finderIn(folder), options).simulator;
}

std::string plugin(const std::string& filename, const std::string& name) {
  return "<plugin filename='" + filename + "' name='" + name + "'/>";
}

std::string boxWith(const std::string& material) {
  return test::modelElement("m", test::linkElement(test::visualElement(
                                     test::kBox, "<material>" + material + "</material>")));
}

TEST(SimulatorOfAWorld, IsClassicUnlessTheFileHasWhatOnlyGzSimKnows) {
  EXPECT_EQ(simulatorOf(test::worldFile("")), Simulator::kClassic);
  EXPECT_EQ(simulatorOf(test::worldFile(boxWith("<diffuse>1 0 0 1</diffuse>"))),
            Simulator::kClassic);
  EXPECT_EQ(simulatorOf(test::worldFile(plugin("libgazebo_ros_factory.so", "factory"))),
            Simulator::kClassic);
}

TEST(SimulatorOfAWorld, IsGzSimWithPhysicallyBasedMaterials) {
  EXPECT_EQ(simulatorOf(test::worldFile(boxWith("<pbr><metal/></pbr>"))), Simulator::kGz);
}

TEST(SimulatorOfAWorld, IsGzSimWithItsPlugins) {
  EXPECT_EQ(simulatorOf(test::worldFile(plugin("libignition-gazebo-physics-system.so",
                                               "ignition::gazebo::systems::Physics"))),
            Simulator::kGz);
  EXPECT_EQ(simulatorOf(test::worldFile(plugin("gz-sim-physics-system", "physics"))),
            Simulator::kGz);
  EXPECT_EQ(simulatorOf(test::worldFile(test::modelElement(
                "m", test::linkElement() + plugin("a.so", "gz::sim::systems::Buoyancy")))),
            Simulator::kGz);
}

TEST(SimulatorOfAWorld, IsWhatTheUserSays) {
  LoadOptions options;
  options.simulator = Simulator::kGz;
  EXPECT_EQ(simulatorOf(test::worldFile(""), options), Simulator::kGz);
  options.simulator = Simulator::kClassic;
  EXPECT_EQ(simulatorOf(test::worldFile(boxWith("<pbr><metal/></pbr>")), options),
            Simulator::kClassic);
}

TEST(SdfMaterial, HasAmbientAndDiffuseColoursOfTheirOwn) {
  const TemporaryFolder folder;
  const auto materialOf = [&](const std::string& material) {
    const std::string visual =
        test::visualElement(test::kBox, "<material>" + material + "</material>");
    return test::loadVisual(folder, visual).surfaces.at(0).material;
  };
  const Material ambient = materialOf("<ambient>0.8 0.2 0.1 1</ambient>");
  EXPECT_EQ(ambient.ambient, Eigen::Vector3f(0.8F, 0.2F, 0.1F));
  EXPECT_EQ(ambient.diffuse, Eigen::Vector4f(1, 1, 1, 1));
  const Material diffuse = materialOf("<diffuse>0.8 0.2 0.1 1</diffuse>");
  EXPECT_EQ(diffuse.ambient, Eigen::Vector3f(1, 1, 1));
  EXPECT_EQ(diffuse.diffuse, Eigen::Vector4f(0.8F, 0.2F, 0.1F, 1));
  EXPECT_FALSE(diffuse.is_default);
  EXPECT_EQ(diffuse.shininess, 0.0F);
  EXPECT_EQ(materialOf("<specular>1 1 1 1</specular><shininess>20</shininess>").shininess, 20.0F);
}

TEST(VisualWithoutMaterial, IsLeftToTheSimulator) {
  const TemporaryFolder folder;
  const Visual visual = test::loadVisual(folder, test::visualElement(test::kBox));
  EXPECT_TRUE(visual.surfaces.at(0).material.is_default);
}

}  // namespace
}  // namespace synthetic_dataset::world

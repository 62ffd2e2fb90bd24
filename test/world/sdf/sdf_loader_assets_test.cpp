#include <cstdlib>

#include <gmock/gmock.h>

#include "world/sdf/sdf_loader_support.h"
#include "world/world_loader.h"

namespace synthetic_dataset::world {
namespace sdf_loader_assets_test {

using namespace test;

std::vector<std::string> namesOf(const Description& world) {
  std::vector<std::string> names;
  for (const Model& model : world.models) names.push_back(model.name);
  return names;
}

TEST(MissingAsset, IsLeftOutWithANote) {
  const TemporaryFolder folder;
  const Description world = loadWithoutMissing(
      folder, worldFile(modelElement(
                  "shelf", linkElement(visualElement(meshElement("gone.dae")) +
                                       "<visual name='w'><geometry>" + kBox +
                                       "</geometry></visual><collision name='c'><geometry>" +
                                       meshElement("away.stl") + "</geometry></collision>"))));
  const Link& link = world.models.at(0).links.at(0);
  ASSERT_THAT(link.visuals, SizeIs(1));
  EXPECT_EQ(link.visuals[0].name, "w");
  EXPECT_THAT(link.collisions, IsEmpty());
  EXPECT_THAT(world.notes,
              ElementsAre(AllOf(HasSubstr("visual 'v': mesh 'gone.dae': no such file; looked in " +
                                          (folder / "gone.dae").string()),
                                HasSubstr("(left out)")),
                          HasSubstr("collision 'c': mesh 'away.stl': no such file")));
}

TEST(MissingAsset, MayBeAMeshThatCannotBeRead) {
  const TemporaryFolder folder;
  folder.write("y.dae", "no COLLADA");
  const Description world = loadWithoutMissing(
      folder, worldFile(modelElement("m", linkElement(visualElement(meshElement("y.dae"))))));
  EXPECT_THAT(world.models.at(0).links.at(0).visuals, IsEmpty());
  EXPECT_THAT(world.notes, ElementsAre(AllOf(HasSubstr("y.dae"), HasSubstr("cannot be read"))));
}

TEST(MissingAsset, MayBeAnIncludedModel) {
  const TemporaryFolder folder;
  folder.write("crate.sdf", boxModel("crate"));
  const Description world = loadWithoutMissing(
      folder,
      worldFile("\n" + includeElement("model://gone") + includeElement("crate.sdf") +
                includeElement("model://gone", "<name>other</name><pose>1 2 3 0 0 0</pose>")));
  EXPECT_THAT(namesOf(world), ElementsAre("crate"));
  EXPECT_THAT(world.notes, ElementsAre(AllOf(HasSubstr("world.sdf: line 2: include 'model://gone'"),
                                             HasSubstr("no such file"), HasSubstr("(left out)"))));
}

TEST(MissingAsset, LeavesTheRestOfAModelThatIncludesIt) {
  const TemporaryFolder folder;
  const Description world = loadWithoutMissing(
      folder, worldFile(modelElement(
                  "cart", linkElement(visualElement(kBox)) +
                              includeElement("model://wheel", "<name>left</name>") +
                              "<joint name='axle' type='revolute'><parent>body</parent>"
                              "<child>left::link</child><axis><xyz>0 1 0</xyz></axis></joint>")));
  ASSERT_THAT(world.models, SizeIs(1));
  ASSERT_THAT(world.models[0].links, SizeIs(1));
  EXPECT_THAT(world.models[0].links[0].visuals, SizeIs(1));
  EXPECT_THAT(world.notes, ElementsAre(HasSubstr("include 'model://wheel'")));
}

TEST(MissingAsset, KeepsPosesRelativeToItRight) {
  const TemporaryFolder folder;
  const Description world = loadWithoutMissing(
      folder,
      worldFile(includeElement("model://gone", "<name>table</name><pose>1 2 3 0 0 0</pose>") +
                modelElement("cup", "<pose relative_to='table'>0 0 1 0 0 0</pose>" +
                                        linkElement(visualElement(kBox)))));
  ASSERT_THAT(namesOf(world), ElementsAre("cup"));
  EXPECT_TRUE(world.models[0].X_WM.translation().isApprox(Eigen::Vector3d(1, 2, 4)));
}

TEST(Includes, MayHaveCommentsInTheirUris) {
  const TemporaryFolder folder;
  folder.write("crate.sdf", boxModel("crate"));
  for (const char* frame : {"", "<pose/><placement_frame>body</placement_frame>"}) {
    const Description world = loadText(
        folder, worldFile(includeElement("<!-- of wood -->crate.sdf<!-- or so -->", frame)));
    EXPECT_THAT(namesOf(world), ElementsAre("crate"));
  }
}

TEST(MissingAsset, MayBeAFileThatIsNoXml) {
  const TemporaryFolder folder;
  folder.write("crate.sdf", boxModel("crate"));
  folder.write("empty.sdf", "");
  folder.write("torn.sdf", "<sdf version='1.6'>\n<model name='torn'>");
  const Description world = loadWithoutMissing(
      folder, worldFile(includeElement("empty.sdf") + includeElement("torn.sdf") +
                        includeElement("crate.sdf")));
  EXPECT_THAT(namesOf(world), ElementsAre("crate"));
  EXPECT_THAT(world.notes, ElementsAre(AllOf(HasSubstr("include 'empty.sdf'"),
                                             HasSubstr("cannot be read as XML")),
                                       HasSubstr("torn.sdf: line 2: cannot be read as XML")));
}

TEST(MissingAsset, MayBeAFileWithoutAModel) {
  const TemporaryFolder folder;
  folder.write("crate.sdf", boxModel("crate"));
  folder.write("bad.sdf", worldFile(""));
  const std::string text = worldFile(includeElement("bad.sdf") + includeElement("crate.sdf"));
  const Description world = loadWithoutMissing(folder, text);
  EXPECT_THAT(namesOf(world), ElementsAre("crate"));
  EXPECT_THAT(world.notes, ElementsAre(AllOf(HasSubstr("include 'bad.sdf': "),
                                             HasSubstr("holds no model, light or actor"))));
  EXPECT_THAT(errorsOf(folder, text), Contains(HasSubstr("bad.sdf")));
}

TEST(MissingAsset, MayBeAFileThatIncludesItself) {
  const TemporaryFolder folder;
  folder.write("a.sdf", modelFile("a", linkElement(visualElement(kBox)) + includeElement("b.sdf")));
  folder.write("b.sdf", modelFile("b", linkElement(visualElement(kBox)) + includeElement("a.sdf")));
  const Description world = loadWithoutMissing(folder, worldFile(includeElement("a.sdf")));
  EXPECT_THAT(world.models.at(0).links, SizeIs(2));
  EXPECT_THAT(world.notes, ElementsAre(HasSubstr("include 'a.sdf': includes itself")));
}

TEST(MissingAsset, IsAnErrorWhereTheWorldItselfIsMissing) {
  const TemporaryFolder folder;
  LoadOptions options;
  options.on_missing_asset = OnMissingAsset::kWarn;
  EXPECT_THROW(static_cast<void>(loadWorld("gone.sdf", test::finderIn(folder), options)),
               ErrorList);
  EXPECT_THROW(static_cast<void>(loadWithoutMissing(folder, "<sdf")), ErrorList);
}

TEST(BuiltInModel, NeedsNoFiles) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, worldFile(includeElement("model://ground_plane") + includeElement("model://sun")));
  ASSERT_THAT(namesOf(world), ElementsAre("ground_plane"));
  EXPECT_TRUE(world.models[0].is_static);
  EXPECT_THAT(world.models[0].links.at(0).collisions, SizeIs(1));
  EXPECT_THAT(world.models[0].links.at(0).visuals, SizeIs(1));
  ASSERT_THAT(world.lights, SizeIs(1));
  EXPECT_EQ(world.lights[0].type, LightType::kDirectional);
  EXPECT_TRUE(world.lights[0].casts_shadow);
  EXPECT_THAT(world.notes, IsEmpty());
}

TEST(BuiltInModel, AnswersToItsNameOnTheModelServer) {
  const TemporaryFolder folder;
  const std::string server = "https://fuel.gazebosim.org/1.0/OpenRobotics/models/";
  const Description world = loadText(
      folder, worldFile(includeElement(server + "Ground Plane") + includeElement(server + "Sun/2") +
                        includeElement(server + "Ground%20Plane", "<name>second</name>")));
  EXPECT_THAT(namesOf(world), ElementsAre("ground_plane", "second"));
  EXPECT_THAT(world.lights, SizeIs(1));
}

TEST(BuiltInModel, GivesWayToTheUsersOwn) {
  const TemporaryFolder folder;
  folder.write("ground_plane/model.config", "<model><sdf version='1.6'>m.sdf</sdf></model>");
  folder.write("ground_plane/m.sdf", boxModel("lawn"));
  EXPECT_THAT(namesOf(loadText(folder, worldFile(includeElement("model://ground_plane")))),
              ElementsAre("lawn"));
}

class FuelCache : public testing::Test {
 protected:
  FuelCache() { setenv("GZ_FUEL_CACHE_PATH", (folder_ / "fuel").c_str(), 1); }
  ~FuelCache() override { unsetenv("GZ_FUEL_CACHE_PATH"); }

  void writeModel(const std::string& version, const std::string& text) const {
    const std::string location = "fuel/fuel.gazebosim.org/openrobotics/models/big crate/" + version;
    folder_.write(location + "/model.config", "<model><sdf version='1.6'>model.sdf</sdf></model>");
    folder_.write(location + "/model.sdf", text);
  }

  TemporaryFolder folder_;
};

TEST_F(FuelCache, HasTheNewestVersion) {
  writeModel("9", boxModel("old"));
  writeModel("10", boxModel("new"));
  for (const std::string uri : {"https://fuel.gazebosim.org/1.0/OpenRobotics/models/Big Crate",
                                "https://fuel.ignitionrobotics.org/1.0/openrobotics/models/"
                                "Big%20Crate/tip",
                                "https://app.gazebosim.org/OpenRobotics/fuel/models/Big%20Crate"}) {
    EXPECT_THAT(namesOf(loadText(folder_, worldFile(includeElement(uri)))), ElementsAre("new"));
  }
}

TEST_F(FuelCache, HasTheVersionAskedFor) {
  writeModel("9", boxModel("old"));
  writeModel("10", boxModel("new"));
  const std::string uri = "https://fuel.gazebosim.org/1.0/OpenRobotics/models/Big Crate/9";
  EXPECT_THAT(namesOf(loadText(folder_, worldFile(includeElement(uri)))), ElementsAre("old"));
}

TEST_F(FuelCache, HasTheModelsMeshes) {
  const std::string uri = "https://fuel.gazebosim.org/1.0/OpenRobotics/models/Big Crate";
  writeModel("1", modelFile("m", linkElement(visualElement(meshElement("model://big_crate/a.obj")) +
                                             "<visual name='w'><geometry>" +
                                             meshElement(uri + "/1/files/a.obj") +
                                             "</geometry></visual>")));
  folder_.write("fuel/fuel.gazebosim.org/openrobotics/models/big crate/1/a.obj",
                test::kTriangleObj);
  const Description world = loadText(folder_, worldFile(includeElement(uri)));
  EXPECT_THAT(world.models.at(0).links.at(0).visuals, SizeIs(2));
}

TEST_F(FuelCache, IsNamedWhereAModelIsMissing) {
  EXPECT_THAT(
      errorsOf(folder_, worldFile(includeElement("https://fuel.gazebosim.org/1.0/X/models/Y Z"))),
      ElementsAre(AllOf(
          HasSubstr("looked in " + (folder_ / "fuel/fuel.gazebosim.org/x/models/y z").string()),
          HasSubstr("nothing is fetched from the network"))));
}

TEST(ModelFolder, MayHaveOnlyOldOrOnlyFutureFiles) {
  const TemporaryFolder folder;
  folder.write("old/model.config", "<model><sdf version='1.4'>model-1_4.sdf</sdf></model>");
  folder.write("old/model-1_4.sdf",
               "<sdf version='1.4'><model name='old'><link name='l'/></model>"
               "</sdf>");
  folder.write("new/model.config",
               "<model><sdf version='1.99'>b.sdf</sdf><sdf version='1.11'>a.sdf</sdf></model>");
  folder.write("new/a.sdf", "<sdf version='1.11'><model name='new'><link name='l'/></model></sdf>");
  folder.write("new/b.sdf", "<sdf version='1.99'><model name='b'><link name='l'/></model></sdf>");
  EXPECT_THAT(namesOf(loadText(folder, worldFile(includeElement("model://old") +
                                                 includeElement("model://new")))),
              ElementsAre("old", "new"));
}

TEST(ModelFolder, MayListFilesThatAreNotThere) {
  const TemporaryFolder folder;
  folder.write("crate/model.config",
               "<model><sdf version='1.6'>gone.sdf</sdf><sdf version='1.5'>here.sdf</sdf></model>");
  folder.write("crate/here.sdf", boxModel("crate"));
  EXPECT_THAT(namesOf(loadText(folder, worldFile(includeElement("model://crate")))),
              ElementsAre("crate"));
}

TEST(SdfVersion, IsAnyFrom1_3On) {
  const TemporaryFolder folder;
  for (const std::string version : {"1.3", "1.4", "1.6", "1.9", "1.10", "1.11"}) {
    const Description world = loadText(
        folder,
        "<sdf version='" + version + "'><world name='w'>" +
            modelElement("m", "<pose>1 2 3 0 0 0</pose>" + linkElement(visualElement(kBox))) +
            "</world></sdf>");
    ASSERT_THAT(world.models, SizeIs(1)) << version;
    EXPECT_TRUE(world.models[0].X_WM.translation().isApprox(Eigen::Vector3d(1, 2, 3)));
    EXPECT_THAT(world.models[0].links.at(0).visuals, SizeIs(1));
  }
}

TEST(SdfVersion, HadAnotherRootOfOld) {
  const TemporaryFolder folder;
  const Description world =
      loadText(folder, "<gazebo version='1.2'>" +
                           modelElement("m", linkElement(visualElement(kBox))) + "</gazebo>");
  EXPECT_THAT(namesOf(world), ElementsAre("m"));
}

TEST(SdfVersion, IsTakenFor1_6WithoutOne) {
  const TemporaryFolder folder;
  EXPECT_THAT(notesOf(folder, "<sdf><world name='w'/></sdf>"),
              ElementsAre(HasSubstr("world.sdf: line 1: <sdf> has no version; it is read as "
                                    "version 1.6")));
}

TEST(SdfVersion, IsTakenFor1_6WhereItIsNoNumber) {
  const TemporaryFolder folder;
  for (const std::string version : {"abc", "", "-1", "1.", "1.x", "1 6"}) {
    EXPECT_THAT(notesOf(folder, "<sdf version='" + version + "'><world name='w'/></sdf>"),
                ElementsAre(HasSubstr("world.sdf: line 1: <sdf> has the version '" + version +
                                      "', which is invalid; it is read as version 1.6")));
  }
}

TEST(SdfVersion, MayBeNewerInIncludedFiles) {
  const TemporaryFolder folder;
  folder.write("crate.sdf",
               "<sdf version='1.11'><model name='crate'><link name='l'>"
               "<inertial auto='true'><density>5</density></inertial></link></model>"
               "</sdf>");
  const Description world = loadText(folder, worldFile(includeElement("crate.sdf")));
  EXPECT_THAT(namesOf(world), ElementsAre("crate"));
  EXPECT_THAT(world.notes, IsEmpty());
}

TEST(Include, MayBeMerged) {
  const TemporaryFolder folder;
  folder.write("arm.sdf", modelFile("arm", "<link name='hand'>" + visualElement(kBox) + "</link>"));
  const Description world =
      loadText(folder,
               "<sdf version='1.9'><world name='w'><model name='robot'><link name='base'/>"
               "<include merge='true'><uri>arm.sdf</uri></include></model></world></sdf>");
  ASSERT_THAT(world.models.at(0).links, SizeIs(2));
  EXPECT_EQ(world.models[0].links[1].name, "hand");
}

TEST(Include, MayBePlacedByAFrame) {
  const TemporaryFolder folder;
  folder.write("arm.sdf", modelFile("arm", "<frame name='grip'><pose>0 0 1 0 0 0</pose></frame>" +
                                               linkElement(visualElement(kBox))));
  const Description world =
      loadText(folder,
               "<sdf version='1.9'><world name='w'><include><uri>arm.sdf</uri>"
               "<pose>0 0 5 0 0 0</pose><placement_frame>grip</placement_frame></include>"
               "</world></sdf>");
  EXPECT_TRUE(world.models.at(0).X_WM.translation().isApprox(Eigen::Vector3d(0, 0, 4)));
}

TEST(SdfLoader, SkipsQuietlyWhatHasNoPartInAPicture) {
  const TemporaryFolder folder;
  testing::internal::CaptureStderr();
  const Description world = loadText(
      folder,
      worldFile("<plugin/><gui><camera/></gui><physics type='ode'/><my:thing>1</my:thing>"
                "<spherical_coordinates/>" +
                modelElement("m", "<plugin filename='x'/>" +
                                      linkElement("<sensor name='s' type='imu'/><my:other/>" +
                                                  visualElement(kBox, "<plugin/>")))));
  EXPECT_THAT(world.notes, IsEmpty());
  EXPECT_THAT(world.models.at(0).links.at(0).visuals, SizeIs(1));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace sdf_loader_assets_test
}  // namespace synthetic_dataset::world

/// URDF through the loader: what becomes of links, joints and visuals.

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "support/error_messages.h"
#include "support/robot_arm.h"
#include "world/sdf/sdf_loader_support.h"

namespace synthetic_dataset::world {
namespace urdf_loader_test {

using synthetic_dataset::test::messagesOf;
using synthetic_dataset::test::TemporaryFolder;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::string robot(const std::string& content) { return "<robot name='r'>" + content + "</robot>"; }

std::string joint(const std::string& type, const std::string& rest) {
  return "<joint name='j' type='" + type + "'><parent link='a'/><child link='b'/>" + rest +
         "</joint>";
}

std::string linkWith(const std::string& visual) {
  return "<link name='a'><visual>" + visual + "</visual></link>";
}

constexpr const char* kCube = "<geometry><box size='1 1 1'/></geometry>";

class UrdfLoader : public testing::Test {
 protected:
  Model load(const std::string& text) {
    return loadModel(folder.write("robot.urdf", text).string(), "alpha", test::finderIn(folder));
  }

  std::vector<std::string> errorsOf(const std::string& text) {
    return test::errorsOfFile(folder, folder.write("robot.urdf", text).string());
  }

  static std::vector<std::string> errorsOfText(const ResourceFinder& finder,
                                               const std::string& text) {
    return messagesOf([&] { static_cast<void>(loadModel(text, "alpha", finder)); });
  }

  TemporaryFolder folder;
};

const Link& linkOf(const Model& model, const std::string& name) {
  for (const Link& link : model.links) {
    if (link.name == name) return link;
  }
  throw Error("no link '" + name + "'");
}

TEST_F(UrdfLoader, KeepsAllLinksAndWhatTheyHangOn) {
  const Model model = load(synthetic_dataset::test::kRobotArm);
  EXPECT_EQ(model.name, "alpha");
  ASSERT_THAT(model.links, SizeIs(5));
  EXPECT_EQ(model.links[0].name, "base_link");
  EXPECT_EQ(model.links[0].parent, std::nullopt);
  EXPECT_EQ(model.links[*linkOf(model, "gripper").parent].name, "fore");
  EXPECT_EQ(linkOf(model, "gripper").moving_joint, "slide");
  EXPECT_EQ(linkOf(model, "nose").moving_joint, "");
  EXPECT_TRUE(linkOf(model, "gripper").X_ML.translation().isApprox(Eigen::Vector3d(0, 0, 1.12)));
  EXPECT_THAT(linkOf(model, "nose").visuals, IsEmpty());
  EXPECT_THAT(linkOf(model, "fore").collisions, SizeIs(1));
}

TEST_F(UrdfLoader, TurnsByRollThenPitchThenYaw) {
  const Model model = load(robot("<link name='a'/><link name='b'/>" +
                                 joint("fixed", "<origin xyz='1 2 3' rpy='0.1 0.2 0.3'/>")));
  const Eigen::Matrix3d R = (Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()) *
                             Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY()) *
                             Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()))
                                .toRotationMatrix();
  EXPECT_TRUE(model.links.at(1).X_ML.linear().isApprox(R, 1e-12));
  EXPECT_EQ(model.links.at(1).X_ML.translation(), Eigen::Vector3d(1, 2, 3));
}

TEST_F(UrdfLoader, KnowsEveryKindOfJoint) {
  const std::string limit = "<limit effort='1' velocity='1' lower='0' upper='1'/>";
  for (const std::string kind :
       {"continuous", "revolute", "prismatic", "floating", "planar", "fixed"}) {
    const Model model = load(
        robot("<link name='a'/><link name='b'/>" + joint(kind, "<origin xyz='0 0 2'/>" + limit)));
    EXPECT_EQ(model.links.at(1).X_ML.translation().z(), 2.0) << kind;
    EXPECT_EQ(model.links.at(1).moving_joint, kind == "fixed" ? "" : "j");
  }
}

TEST_F(UrdfLoader, PutsAMimicAtItsOffset) {
  const std::string driver =
      "<link name='a'/><link name='b'/><link name='c'/><joint name='k' type='continuous'>"
      "<parent link='a'/><child link='c'/></joint>";
  const std::string mimic = "<axis xyz='0 0 2'/><mimic joint='k' multiplier='3' offset='0.5'/>";
  const Model turned = load(robot(driver + joint("continuous", mimic)));
  EXPECT_TRUE(
      linkOf(turned, "b")
          .X_ML.linear()
          .isApprox(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()).toRotationMatrix(), 1e-12));
  const Model moved =
      load(robot(driver + joint("prismatic", mimic + "<limit effort='1' velocity='1' lower='0' "
                                                     "upper='1'/>")));
  EXPECT_TRUE(linkOf(moved, "b").X_ML.translation().isApprox(Eigen::Vector3d(0, 0, 0.5)));
}

TEST_F(UrdfLoader, ReadsInertiasInTheirTurnedFrames) {
  const Model model = load(
      robot("<link name='a'><inertial><origin xyz='1 0 0' rpy='0 0 1.57079632679489662'/>"
            "<mass value='2'/><inertia ixx='1' iyy='2' izz='3' ixy='0' ixz='0' iyz='0'/></inertial>"
            "</link>"));
  ASSERT_TRUE(model.links[0].inertia);
  EXPECT_EQ(model.links[0].inertia->mass, 2.0);
  EXPECT_EQ(model.links[0].inertia->centre_of_mass_L, Eigen::Vector3d(1, 0, 0));
  EXPECT_TRUE(model.links[0].inertia->moments_L.isApprox(
      Eigen::Matrix3d(Eigen::Vector3d(2, 1, 3).asDiagonal()), 1e-9));
}

TEST_F(UrdfLoader, GivesVisualsTheirColours) {
  const Model model =
      load(robot("<material name='green'><color rgba='0 1 0 0.5'/></material>"
                 "<link name='a'><visual>" +
                 std::string(kCube) +
                 "<material name='green'/></visual>"
                 "<visual>" +
                 kCube +
                 "<material name='own'><color rgba='0 0 1 1'/></material></visual>"
                 "<visual>" +
                 kCube + "</visual></link>"));
  const std::vector<Visual>& visuals = model.links.at(0).visuals;
  ASSERT_THAT(visuals, SizeIs(3));
  EXPECT_EQ(visuals[0].surfaces[0].material.diffuse, Eigen::Vector4f(0, 1, 0, 0.5F));
  EXPECT_EQ(visuals[1].surfaces[0].material.diffuse, Eigen::Vector4f(0, 0, 1, 1));
  EXPECT_EQ(visuals[2].surfaces[0].material.diffuse, Material{}.diffuse);
}

TEST_F(UrdfLoader, ShowsTexturesInsteadOfColours) {
  const cv::Mat3b pixels(2, 2, cv::Vec3b(10, 20, 30));
  cv::imwrite((folder / "wood.png").string(), pixels);
  const Model model =
      load(robot(linkWith(std::string(kCube) + "<material name='m'><texture filename='wood.png'/>"
                                               "</material>")));
  const Material& material = model.links.at(0).visuals.at(0).surfaces.at(0).material;
  ASSERT_TRUE(material.texture);
  EXPECT_EQ(material.texture->pixels.at<cv::Vec4b>(0, 0), cv::Vec4b(10, 20, 30, 255));
  EXPECT_EQ(material.diffuse, Eigen::Vector4f(1, 1, 1, 1));
}

TEST_F(UrdfLoader, LeavesMeshFilesTheirOwnMaterials) {
  folder.write("own.mtl", "newmtl paint\nKd 1 0 0\n");
  folder.write("own.obj", "mtllib own.mtl\nusemtl paint\n" + std::string(test::kTriangleObj));
  folder.write("bare.obj", test::kTriangleObj);
  const std::string blue = "<material name='m'><color rgba='0 0 1 1'/></material>";
  const Model model =
      load(robot("<link name='a'><visual><geometry><mesh filename='own.obj'/></geometry>" + blue +
                 "</visual><visual><geometry><mesh filename='bare.obj' scale='2 2 2'/></geometry>" +
                 blue + "</visual></link>"));
  const std::vector<Visual>& visuals = model.links.at(0).visuals;
  EXPECT_EQ(visuals.at(0).surfaces.at(0).material.diffuse, Eigen::Vector4f(1, 0, 0, 1));
  EXPECT_EQ(visuals.at(1).surfaces.at(0).material.diffuse, Eigen::Vector4f(0, 0, 1, 1));
  EXPECT_EQ(visuals.at(1).surfaces.at(0).mesh->positions[2], Eigen::Vector3f(0, 4, 0));
}

TEST_F(UrdfLoader, FindsMeshesOfPackages) {
  folder.write("pkg/meshes/part.obj", test::kTriangleObj);
  const ResourceFinder finder({}, [&](const std::string& package) -> std::optional<std::string> {
    if (package == "my_robot") return (folder / "pkg").string();
    return std::nullopt;
  });
  const std::vector<std::string> uris = {
      "package://my_robot/meshes/part.obj", "$(find my_robot)/meshes/part.obj",
      "file://$(optenv NO_SUCH_THING_IS_SET " + folder.path().string() + ")/pkg/meshes/part.obj"};
  for (const std::string& uri : uris) {
    const std::string text = robot(linkWith("<geometry><mesh filename='" + uri + "'/></geometry>"));
    EXPECT_THAT(loadModel(text, "alpha", finder).links.at(0).visuals, SizeIs(1)) << uri;
  }
}

TEST_F(UrdfLoader, LeavesOutWhatOnlyXacroCouldResolve) {
  const ResourceFinder finder = test::finderIn(folder);
  WorldLoader loader(finder);
  const auto file =
      folder.write("robot.urdf", robot("<link name='a'/><link name='b'/>" +
                                       joint("fixed", "<origin xyz='$(arg place)' rpy='0 0 0'/>")));
  EXPECT_THAT(loader.loadModel(file.string(), "alpha").links, SizeIs(2));
  EXPECT_THAT(loader.modelNotes(),
              ElementsAre(AllOf(HasSubstr("robot.urdf: line 1: <origin xyz=\"$(arg place)\">"),
                                HasSubstr("left out"))));
}

TEST_F(UrdfLoader, SkipsBlocksOfOtherPrograms) {
  const ResourceFinder finder = test::finderIn(folder);
  WorldLoader loader(finder);
  const auto file = folder.write(
      "robot.urdf", robot("<link name='a'/><gazebo><plugin name='p' filename='${x}'/></gazebo>"
                          "<gazebo reference='a'><mu1>0.2</mu1></gazebo><transmission name='t'/>"));
  EXPECT_THAT(loader.loadModel(file.string(), "alpha").links, SizeIs(1));
  EXPECT_THAT(loader.modelNotes(), IsEmpty());
}

TEST_F(UrdfLoader, LeavesOutShapesThatSayNothing) {
  const ResourceFinder finder = test::finderIn(folder);
  const std::vector<std::pair<std::string, std::string>> links{
      {linkWith("<geometry><box size='1 1'/></geometry>"),
       "visual '1': its box's size is '1 1'; it should be 3"},
      {linkWith("<geometry><box size='0 0 0'/></geometry>"), "visual '1': box size"},
      {linkWith("<geometry><box size='1 -1 1'/></geometry>"), "visual '1': box size"},
      {linkWith("<geometry><sphere radius='0'/></geometry>"), "visual '1': sphere radius"},
      {linkWith("<geometry><cylinder radius='1'/></geometry>"), "its cylinder has no length"},
      {linkWith("<geometry/>"), "visual '1': has no geometry"},
      {linkWith(""), "visual '1': has no geometry"},
      {linkWith("<geometry><cone radius='1'/></geometry>"), "its geometry, a 'cone'"},
      {linkWith("<geometry><mesh filename='x.stl' scale='1 0 1'/></geometry>"), "mesh scale"},
      {"<link name='a'><collision><geometry/></collision></link>",
       "collision '1': has no geometry"},
      {"<link name='a'><collision><geometry><mesh filename='gone.stl'/></geometry></collision>"
       "</link>",
       "collision '1': mesh 'gone.stl': no such file"}};
  for (const auto& [link, message] : links) {
    WorldLoader loader(finder);
    const auto file = folder.write("robot.urdf", robot(link));
    const Model model = loader.loadModel(file.string(), "alpha");
    EXPECT_THAT(model.links.at(0).visuals, IsEmpty()) << link;
    EXPECT_THAT(model.links.at(0).collisions, IsEmpty()) << link;
    EXPECT_THAT(loader.modelNotes(),
                Contains(AllOf(HasSubstr("robot.urdf: line 1: link 'a': "), HasSubstr(message))))
        << link;
  }
}

TEST_F(UrdfLoader, ReadsRobotsOfWhichNoPictureNeedsAll) {
  const std::vector<std::string> robots = {
      "<link name='a'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1'/></inertial>",
      "<link name='a'><inertial><mass value='nan'/></inertial>",
      "<link name='b'/><joint name='j' type='revolute'><parent link='a'/><child link='b'/>"
      "<limit lower='-1' upper='1'/><safety_controller/></joint><link name='a'>",
      "<link name='a'><collision><geometry><capsule radius='1' length='2'/></geometry>"
      "</collision>"};
  for (const std::string& each : robots) {
    const Model model = load(robot(each + "<visual>" + std::string(kCube) + "</visual></link>"));
    EXPECT_THAT(linkOf(model, "a").visuals, SizeIs(1)) << each;
  }
}

TEST_F(UrdfLoader, DrawsCapsules) {
  const Model model =
      load(robot(linkWith("<geometry><capsule radius='0.1' length='0.2'/></geometry>")));
  float highest = 0.0F;
  for (const auto& p : model.links.at(0).visuals.at(0).surfaces.at(0).mesh->positions) {
    highest = std::max(highest, p.z());
  }
  EXPECT_NEAR(highest, 0.2F, 1e-5F) << "half of the length, and the radius";
}

TEST_F(UrdfLoader, ShowsALinkAsGazeboIsTold) {
  const std::string blue = "<material name='m'><color rgba='0 0 1 1'/></material>";
  const Model model = load(robot(
      linkWith(kCube + blue) +
      "<gazebo reference='a'><material>Gazebo/Red</material><turnGravityOff>true</turnGravityOff>"
      "<visual><material><ambient>0 1 0 1</ambient><diffuse>0 1 0 1</diffuse></material>"
      "<transparency>0.25</transparency><cast_shadows>false</cast_shadows></visual></gazebo>"));
  const Link& link = model.links.at(0);
  EXPECT_FALSE(link.has_gravity);
  EXPECT_FALSE(link.visuals.at(0).casts_shadow);
  EXPECT_EQ(link.visuals.at(0).surfaces.at(0).material.diffuse, Eigen::Vector4f(0, 1, 0, 0.75F));
}

TEST_F(UrdfLoader, FindsCamerasOnLinksOfFixedJoints) {
  const ResourceFinder finder = test::finderIn(folder);
  WorldLoader loader(finder);
  const auto file = folder.write(
      "robot.urdf",
      robot("<link name='a'/><link name='b'/>" + joint("fixed", "<origin xyz='0.5 0 1'/>") +
            "<gazebo reference='b'><sensor type='camera' name='eye'><pose>0.1 0 0 0 0 0</pose>"
            "<camera><horizontal_fov>1</horizontal_fov><image><width>320</width>"
            "<height>240</height></image></camera></sensor></gazebo>"));
  (void)loader.loadModel(file.string(), "rover");
  ASSERT_THAT(loader.modelCameras(), SizeIs(1));
  const CameraSensor& camera = loader.modelCameras().front();
  EXPECT_EQ(camera.name, "rover::b::eye");
  EXPECT_EQ(camera.link, "b");
  EXPECT_TRUE(camera.X_WC.translation().isApprox(Eigen::Vector3d(0.6, 0, 1)));
  EXPECT_TRUE(camera.X_WC.linear().col(2).isApprox(Eigen::Vector3d::UnitX())) << "looks along x";
}

TEST_F(UrdfLoader, FindsLidarsOnLinksOfFixedJoints) {
  const ResourceFinder finder = test::finderIn(folder);
  WorldLoader loader(finder);
  const auto file = folder.write(
      "robot.urdf",
      robot("<link name='a'/><link name='b'/>" + joint("fixed", "<origin xyz='0.5 0 1'/>") +
            "<gazebo reference='b'><sensor type='gpu_ray' name='scan'><pose>0.1 0 0 0 0 0</pose>"
            "<update_rate>5</update_rate><ray><scan><horizontal><samples>90</samples>"
            "<min_angle>-1</min_angle><max_angle>1</max_angle></horizontal></scan>"
            "<range><min>0.2</min><max>30</max></range></ray></sensor></gazebo>"));
  (void)loader.loadModel(file.string(), "rover");
  ASSERT_THAT(loader.modelLidars(), SizeIs(1));
  const LidarSensor& lidar = loader.modelLidars().front();
  EXPECT_EQ(lidar.name, "rover::b::scan");
  EXPECT_EQ(lidar.link, "b");
  EXPECT_TRUE(lidar.X_WS.translation().isApprox(Eigen::Vector3d(0.6, 0, 1)));
  EXPECT_EQ(lidar.update_rate, 5.0);
}

TEST_F(UrdfLoader, TakesColoursOfAnStlForNoneWhereTheFileGivesOne) {
  std::string stl(80, ' ');
  stl += std::string("\1\0\0\0", 4);
  const float numbers[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  stl.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
  stl += std::string("\0\x80", 2);  // black, with the bit that marks a colour
  (void)folder.write("a.stl", stl);
  const Model model =
      load(robot(linkWith("<geometry><mesh filename='a.stl'/></geometry>"
                          "<material name='m'><color rgba='0.9 0.1 0.1 1'/></material>")));
  const Surface& surface = model.links.at(0).visuals.at(0).surfaces.at(0);
  EXPECT_THAT(surface.mesh->colours, IsEmpty());
  EXPECT_EQ(surface.material.diffuse, Eigen::Vector4f(0.9F, 0.1F, 0.1F, 1));
}

TEST_F(UrdfLoader, PutsInTheEntitiesOfItsDocumentType) {
  const Model model = load("<?xml version='1.0'?>\n<!DOCTYPE robot [<!ENTITY s \"0.4\">]>\n" +
                           robot(linkWith("<geometry><box size='&s; &s; 1'/></geometry>")));
  EXPECT_EQ(
      model.links.at(0).visuals.at(0).surfaces.at(0).mesh->positions[0].x() * 2.0F,
      model.links.at(0).visuals.at(0).surfaces.at(0).mesh->positions[0].x() < 0 ? -0.4F : 0.4F);
}

TEST_F(UrdfLoader, DrawsAVisualWithoutAColourThatIsNone) {
  const ResourceFinder finder = test::finderIn(folder);
  const std::vector<std::pair<std::string, std::string>> materials{
      {"<material name='gone'/>", "line 1: link 'a': the material 'gone' is defined nowhere"},
      {"<material name='m'><color rgba='nan 0 0 1'/></material>", "color: found 'nan 0 0 1'"}};
  for (const auto& [material, message] : materials) {
    WorldLoader loader(finder);
    const auto file = folder.write("robot.urdf", robot(linkWith(kCube + material)));
    const Model model = loader.loadModel(file.string(), "alpha");
    ASSERT_THAT(model.links.at(0).visuals, SizeIs(1)) << material;
    EXPECT_EQ(model.links[0].visuals[0].surfaces.at(0).material.diffuse, Material().diffuse);
    EXPECT_THAT(loader.modelNotes(), ElementsAre(HasSubstr(message)));
  }
}

TEST_F(UrdfLoader, LeavesOutVisualsThatAreWhollyTransparent) {
  const std::string clear = "<material name='m'><color rgba='1 0 0 0'/></material>";
  const std::string faint = "<material name='m'><color rgba='1 0 0 0.1'/></material>";
  EXPECT_THAT(load(robot(linkWith(kCube + clear))).links.at(0).visuals, IsEmpty());
  EXPECT_THAT(load(robot(linkWith(kCube + faint))).links.at(0).visuals, SizeIs(1));
}

TEST_F(UrdfLoader, GivesAMeshWithoutItsLibraryItsOwnColour) {
  folder.write("a.obj", "mtllib gone.mtl\nusemtl red\n" + std::string(test::kTriangleObj));
  const Model model =
      load(robot(linkWith("<geometry><mesh filename='a.obj'/></geometry>"
                          "<material name='m'><color rgba='0 1 0 1'/></material>")));
  EXPECT_EQ(model.links.at(0).visuals.at(0).surfaces.at(0).material.diffuse,
            Eigen::Vector4f(0, 1, 0, 1));
}

TEST_F(UrdfLoader, NotesMaterialsThatGazeboDoesNotShip) {
  const ResourceFinder finder = test::finderIn(folder);
  WorldLoader loader(finder);
  const auto file = folder.write(
      "robot.urdf", robot(linkWith(kCube) + "<gazebo reference='a'><material>Gazebo/Gray"
                                            "</material></gazebo>"));
  EXPECT_THAT(loader.loadModel(file.string(), "alpha").links.at(0).visuals, SizeIs(1));
  EXPECT_THAT(loader.modelNotes(),
              ElementsAre(AllOf(HasSubstr("link 'a': Gazebo ships no material 'Gazebo/Gray'"),
                                HasSubstr("did you mean 'Gazebo/Grey'?"))));
}

/// Links '0', '1', ... each on the one before it.
std::string chain(int count) {
  std::string content = "<link name='0'/>";
  for (int i = 1; i < count; ++i) {
    const std::string name = std::to_string(i);
    content += "<link name='" + name + "'/><joint name='j" + name +
               "' type='fixed'><parent link='" + std::to_string(i - 1) + "'/><child link='" + name +
               "'/></joint>";
  }
  return robot(content);
}

TEST_F(UrdfLoader, RefusesChainsThatAreTooLong) {
  EXPECT_THAT(load(chain(1000)).links, SizeIs(1000));
  EXPECT_THAT(errorsOf(chain(1001)),
              ElementsAre(AllOf(HasSubstr("robot.urdf: line 1: a chain of 1001 links"),
                                HasSubstr("at most 1000"))));
  EXPECT_THAT(errorsOf(chain(20000)), ElementsAre(HasSubstr("a chain of 20000 links")));
}

TEST_F(UrdfLoader, ReadsAModelsText) {
  const ResourceFinder finder = test::finderIn(folder);
  EXPECT_THAT(loadModel("\n " + robot("<link name='a'/>"), "alpha", finder).links, SizeIs(1));
  const Model sdf =
      loadModel("<?xml version='1.0'?>" +
                    test::modelFile("m", test::linkElement(test::visualElement(test::kBox))),
                "alpha", finder);
  EXPECT_EQ(sdf.name, "alpha");
  EXPECT_THAT(sdf.links.at(0).visuals, SizeIs(1));
}

TEST_F(UrdfLoader, SaysThatATextHasNoFolder) {
  const ResourceFinder finder = test::finderIn(folder);
  EXPECT_THAT(
      errorsOfText(finder, robot(linkWith("<geometry><mesh filename='a.stl'/></geometry>"))),
      ElementsAre(AllOf(HasSubstr("link 'a': visual '1': mesh 'a.stl': no such file"),
                        HasSubstr("package://, model:// and absolute paths"))));
  EXPECT_THAT(errorsOfText(finder, test::modelFile("m", test::linkElement(test::visualElement(
                                                            test::meshElement("a.stl"))))),
              ElementsAre(AllOf(HasSubstr("the text of alpha/model"),
                                HasSubstr("package://, model:// and absolute paths"))));
}

struct BadUrdf {
  std::string content;
  std::string message;
};

class BadUrdfs : public UrdfLoader, public testing::WithParamInterface<BadUrdf> {};

TEST_P(BadUrdfs, AreErrorsThatSayWhy) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const std::vector<std::string> errors = errorsOf(robot(GetParam().content));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_THAT(errors, ElementsAre(AllOf(HasSubstr("robot.urdf: "), HasSubstr(GetParam().message))));
}

const std::string kTwo = "<link name='a'/><link name='b'/>";

INSTANTIATE_TEST_SUITE_P(
    UrdfLoader, BadUrdfs,
    testing::Values(
        BadUrdf{"", "line 1: has no <link>"},
        BadUrdf{kTwo, "the links 'a', 'b' have no parent; a robot has one root"},
        BadUrdf{"<link name='a'/><link name='a'/>", "link 'a' is there twice"},
        BadUrdf{"<link name='b'/>" + joint("fixed", ""),
                "joint 'j': its parent 'a' is not a link of the robot"},
        BadUrdf{kTwo + joint("fixed", "") +
                    "<joint name='k' type='fixed'><parent link='b'/><child link='a'/></joint>",
                "all links have parents, forming a loop"},
        BadUrdf{"<link name='root'/>" + kTwo + joint("fixed", "") +
                    "<joint name='k' type='fixed'><parent link='b'/><child link='a'/></joint>",
                "the links 'a', 'b' form a loop"},
        BadUrdf{"<link name='c'/>" + kTwo + joint("fixed", "") +
                    "<joint name='k' type='fixed'><parent link='a'/><child link='c'/></joint>"
                    "<joint name='l' type='fixed'><parent link='c'/><child link='b'/></joint>",
                "link 'b' is the child of joint 'j' and of joint 'l'"},
        BadUrdf{linkWith("<geometry><mesh filename='gone.stl'/></geometry>"),
                "visual '1': mesh 'gone.stl': no such file; looked in "},
        BadUrdf{linkWith("<geometry><box size='${width} 1 1'/></geometry>"), "rosrun xacro xacro"},
        BadUrdf{"<xacro:include filename='x'/><link name='a'/>",
                "line 1: 'xacro:include' is xacro's"},
        BadUrdf{"<link name='a'>", "cannot be read as XML"}));

}  // namespace urdf_loader_test
}  // namespace synthetic_dataset::world

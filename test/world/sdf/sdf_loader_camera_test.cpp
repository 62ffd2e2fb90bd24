#include <gmock/gmock.h>

#include "world/sdf/sdf_loader_support.h"
#include "world/world_loader.h"

namespace synthetic_dataset::world {
namespace sdf_loader_camera_test {

using namespace test;

std::string cameraWorld(const std::string& camera, const std::string& type = "camera") {
  return worldFile(modelElement("robot", "<pose>0 0 1 0 0 1.57079632679489662</pose>" +
                                             linkElement("<sensor name='eye' type='" + type +
                                                         "'><pose>1 0 0 0 0 0</pose>"
                                                         "<camera>" +
                                                         camera + "</camera></sensor>")));
}

constexpr const char* kImage = "<image><width>640</width><height>480</height></image>";
const std::string kRightAngle = "<horizontal_fov>1.57079632679489662</horizontal_fov>";

CameraSensor loadCamera(const std::string& camera) {
  const TemporaryFolder folder;
  return loadText(folder, cameraWorld(camera)).cameras.at(0);
}

TEST(SdfCamera, LooksAlongItsLinksX) {
  const CameraSensor camera = loadCamera(kRightAngle + kImage);
  EXPECT_EQ(camera.name, "robot::body::eye");
  // After a quarter turn, the model's x is the world's y; the camera is 1 m along it.
  const Eigen::Vector3d p_WC = camera.X_WC.translation();
  EXPECT_TRUE(p_WC.isApprox(Eigen::Vector3d(0, 1, 1), 1e-9));
  EXPECT_TRUE((camera.X_WC * Eigen::Vector3d(0, 0, 1) - p_WC).isApprox(Eigen::Vector3d(0, 1, 0)));
  EXPECT_TRUE((camera.X_WC * Eigen::Vector3d(1, 0, 0) - p_WC).isApprox(Eigen::Vector3d(1, 0, 0)));
  EXPECT_TRUE((camera.X_WC * Eigen::Vector3d(0, 1, 0) - p_WC).isApprox(Eigen::Vector3d(0, 0, -1)));
}

TEST(SdfCamera, HasGazebosIntrinsics) {
  const CameraModel camera = loadCamera(kRightAngle + kImage).camera;
  EXPECT_EQ(camera.width(), 640);
  EXPECT_EQ(camera.height(), 480);
  EXPECT_NEAR(camera.intrinsics().fx, 320.0, 1e-9);  // half the width at 45 degrees
  EXPECT_NEAR(camera.intrinsics().fy, 320.0, 1e-9);
  EXPECT_DOUBLE_EQ(camera.intrinsics().cx, 319.5);
  EXPECT_DOUBLE_EQ(camera.intrinsics().cy, 239.5);
}

TEST(SdfCamera, TakesIntrinsicsOfTheFileAsTheyAre) {
  const CameraModel camera =
      loadCamera(kRightAngle + kImage +
                 "<lens><intrinsics><fx>500</fx><fy>501</fy><cx>320</cx><cy>240</cy><s>0</s>"
                 "</intrinsics></lens>")
          .camera;
  EXPECT_DOUBLE_EQ(camera.intrinsics().fx, 500.0);
  EXPECT_DOUBLE_EQ(camera.intrinsics().fy, 501.0);
  EXPECT_DOUBLE_EQ(camera.intrinsics().cx, 320.0);
  EXPECT_DOUBLE_EQ(camera.intrinsics().cy, 240.0);
}

TEST(SdfCamera, ClipsAsTheFileSays) {
  EXPECT_DOUBLE_EQ(loadCamera(kRightAngle + kImage).camera.far(), 1000.0);
  const CameraModel camera =
      loadCamera(kRightAngle + kImage + "<clip><near>0.2</near><far>30</far></clip>").camera;
  EXPECT_DOUBLE_EQ(camera.near(), 0.2);
  EXPECT_DOUBLE_EQ(camera.far(), 30.0);
}

TEST(SdfCamera, IsNoOtherSensor) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, worldFile(modelElement("m", linkElement("<sensor name='imu' type='imu'/>"))));
  EXPECT_THAT(world.cameras, IsEmpty());
}

TEST(SdfCamera, IsLeftOutWithAnImpossibleAngle) {
  const TemporaryFolder folder;
  EXPECT_THAT(
      test::notesOf(
          folder, cameraWorld(std::string("<horizontal_fov>3.1415926</horizontal_fov>") + kImage)),
      ElementsAre(HasSubstr("model 'robot': link 'body': sensor 'eye': horizontal_fov")));
}

TEST(SdfLight, ReadsASpot) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder,
      worldFile("<light name='lamp' type='spot'><pose>1 2 3 0 0 0</pose>"
                "<diffuse>0.5 0.6 0.7 1</diffuse><direction>0 1 -1</direction>"
                "<cast_shadows>true</cast_shadows><attenuation><range>7</range>"
                "<constant>0.1</constant><linear>0.2</linear><quadratic>0.3</quadratic>"
                "</attenuation><spot><inner_angle>0.4</inner_angle><outer_angle>0.8</outer_angle>"
                "<falloff>2</falloff></spot></light>"));
  ASSERT_THAT(world.lights, SizeIs(1));
  const Light& light = world.lights[0];
  EXPECT_EQ(light.type, LightType::kSpot);
  EXPECT_TRUE(light.X_WL.translation().isApprox(Eigen::Vector3d(1, 2, 3)));
  EXPECT_EQ(light.direction_L, Eigen::Vector3d(0, 1, -1));
  EXPECT_TRUE(light.diffuse.isApprox(Eigen::Vector3f(0.5F, 0.6F, 0.7F)));
  EXPECT_TRUE(light.casts_shadow);
  EXPECT_DOUBLE_EQ(light.range, 7.0);
  EXPECT_DOUBLE_EQ(light.attenuation_constant, 0.1);
  EXPECT_DOUBLE_EQ(light.attenuation_linear, 0.2);
  EXPECT_DOUBLE_EQ(light.attenuation_quadratic, 0.3);
  EXPECT_DOUBLE_EQ(light.spot_inner_angle, 0.4);
  EXPECT_DOUBLE_EQ(light.spot_outer_angle, 0.8);
  EXPECT_DOUBLE_EQ(light.spot_falloff, 2.0);
}

TEST(SdfLight, MovesWithItsLink) {
  const TemporaryFolder folder;
  const Description world = loadText(
      folder, worldFile(modelElement(
                  "m", "<pose>1 0 0 0 0 0</pose>" +
                           linkElement("<pose>0 1 0 0 0 0</pose><light name='lamp' type='point'>"
                                       "<pose>0 0 1 0 0 0</pose></light>"))));
  ASSERT_THAT(world.lights, SizeIs(1));
  EXPECT_EQ(world.lights[0].name, "m::body::lamp");
  EXPECT_EQ(world.lights[0].type, LightType::kPoint);
  EXPECT_TRUE(world.lights[0].X_WL.translation().isApprox(Eigen::Vector3d(1, 1, 1)));
}

TEST(SdfLight, IsReadFromAnIncludedFile) {
  const TemporaryFolder folder;
  folder.write("sun/model.config",
               "<model><name>Sun</name><sdf version='1.5'>model.sdf</sdf></model>");
  folder.write("sun/model.sdf",
               "<sdf version='1.5'><light name='sun' type='directional'>"
               "<direction>0 0 -1</direction></light></sdf>");
  EXPECT_THAT(loadText(folder, worldFile("<include><uri>model://sun</uri></include>")).lights,
              SizeIs(1));
  EXPECT_THAT(loadWorld("model://sun", test::finderIn(folder)).lights, SizeIs(1));
}

TEST(SdfLight, CastsNoShadowsWhereTheSceneHasNone) {
  const TemporaryFolder folder;
  const Description world =
      loadText(folder, worldFile("<scene><shadows>false</shadows></scene><light name='sun' "
                                 "type='directional'><cast_shadows>true</cast_shadows></light>"));
  EXPECT_FALSE(world.lights.at(0).casts_shadow);
}

TEST(SdfCamera, IsEachOneOfAMulticamera) {
  const TemporaryFolder folder;
  const std::string text = worldFile(modelElement(
      "mast",
      linkElement("<sensor name='two' type='multicamera'><camera name='left'>" + kRightAngle +
                  kImage + "</camera><camera name='right'>" + "<pose>0 -0.5 0 0 0 0</pose>" +
                  kRightAngle + kImage + "</camera></sensor>")));
  const std::vector<CameraSensor> cameras = loadText(folder, text).cameras;
  ASSERT_EQ(cameras.size(), 2U);
  EXPECT_EQ(cameras[0].name, "mast::body::two::left");
  EXPECT_EQ(cameras[1].name, "mast::body::two::right");
  EXPECT_TRUE(cameras[1].X_WC.translation().isApprox(Eigen::Vector3d(0, -0.5, 0)));
}

TEST(SdfCamera, IsOfWhateverTypeItsSensorIs) {
  const TemporaryFolder folder;
  std::string sensors;
  for (const char* type :
       {"depth", "rgbd_camera", "thermal_camera", "segmentation", "boundingbox_camera"}) {
    sensors += "<sensor name='" + std::string(type) + "' type='" + type + "'><camera>" +
               kRightAngle + kImage + "</camera></sensor>";
  }
  sensors += "<sensor name='logical' type='logical_camera'><logical_camera/></sensor>";
  const std::string text = worldFile(modelElement("mast", linkElement(sensors)));
  EXPECT_THAT(loadText(folder, text).cameras, SizeIs(5));
}

}  // namespace sdf_loader_camera_test
}  // namespace synthetic_dataset::world

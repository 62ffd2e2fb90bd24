/// The look of surfaces in worlds for Gazebo Classic: pixels by OGRE 1's formula
/// (classic_shading.h), in the numbers of the files.

#include <cmath>

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "render/picture_taking.h"
#include "render/renderer.h"

namespace synthetic_dataset::render {
namespace classic_material_test {

using test::halvedTexture;
using test::kSmallCamera;
using test::plainTexture;
using test::screen;
using test::Stage;
using test::takePicture;

/// A scene with an ambient light of 0.4 and a sun of 0.5 that shines along the view, onto a screen.
world::Description classic() {
  world::Description description;
  description.ambient.setConstant(0.4F);
  description.background.setConstant(0.2F);
  world::Light sun;
  sun.direction_L = {0, 0, 1};
  sun.diffuse.setConstant(0.5F);
  sun.specular.setConstant(0.5F);
  description.lights.push_back(sun);
  return description;
}

cv::Vec3b middle(const world::Description& description, const world::Material& material) {
  Stage stage;
  stage.addMesh(screen(1.0F, 2.0F), Pose::Identity(), 0, material);
  const cv::Vec3b bgr = takePicture(description, stage).at<cv::Vec3b>(24, 32);
  return {bgr[2], bgr[1], bgr[0]};
}

void expectColour(const cv::Vec3b& found, double red, double green, double blue) {
  EXPECT_NEAR(found[0], 255.0 * red, 1.0);
  EXPECT_NEAR(found[1], 255.0 * green, 1.0);
  EXPECT_NEAR(found[2], 255.0 * blue, 1.0);
}

TEST(ClassicMaterial, IsWhiteWhereNobodyHasGivenOne) {
  expectColour(middle(classic(), world::defaultMaterial()), 0.9, 0.9, 0.9);
}

TEST(ClassicMaterial, AnswersToAmbientLightWithAnAmbientColourAndToOthersWithADiffuseOne) {
  world::Material material;
  material.ambient = {1.0F, 0.5F, 0.0F};
  expectColour(middle(classic(), material), 0.5 + 0.4, 0.5 + 0.2, 0.5);
  material.diffuse = {0.2F, 0.4F, 0.6F, 1.0F};
  expectColour(middle(classic(), material), 0.1 + 0.4, 0.2 + 0.2, 0.3);
}

TEST(ClassicMaterial, TakesFromPointLightsWhatTheirDistanceLeaves) {
  world::Description description = classic();
  world::Light& light = description.lights[0];
  light.type = world::LightType::kPoint;
  light.attenuation_constant = 0.5;
  light.attenuation_linear = 0.25;
  light.attenuation_quadratic = 0.1;  // from 2 m: 1 / (0.5 + 0.5 + 0.4)
  expectColour(middle(description, {}), 0.4 + 0.5 / 1.4, 0.4 + 0.5 / 1.4, 0.4 + 0.5 / 1.4);
  light.range = 1.9;
  expectColour(middle(description, {}), 0.4, 0.4, 0.4);
}

TEST(ClassicMaterial, MultipliesItsTextureByTheSumOfTheLights) {
  world::Material material;
  material.texture = plainTexture({51, 102, 204, 255});
  expectColour(middle(classic(), material), 0.9 * 0.8, 0.9 * 0.4, 0.9 * 0.2);
  material.emissive.setConstant(0.1F);
  expectColour(middle(classic(), material), 0.8, 0.4, 0.2);
}

TEST(ClassicMaterial, GlowsByAPictureOfItsOwnBesideTheTexture) {
  world::Material material;
  material.texture = plainTexture({51, 51, 51, 255});
  material.emissive.setConstant(0.5F);
  material.emissive_map = plainTexture({0, 0, 255, 255});
  expectColour(middle(classic(), material), 0.9 * 0.2 + 0.5, 0.9 * 0.2, 0.9 * 0.2);
}

TEST(ClassicMaterial, HasAHighlightOfItsSpecularHueWithAShininessAlone) {
  world::Material material;
  material.diffuse.head<3>().setZero();
  material.ambient.setZero();
  material.specular = {1.0F, 0.4F, 0.0F};
  expectColour(middle(classic(), material), 0.0, 0.0, 0.0);
  material.shininess = 20.0F;
  expectColour(middle(classic(), material), 0.5, 0.2, 0.0);
}

TEST(ClassicMaterial, HasNoHazeAtGrazingAngles) {
  // A floor 1 m below that reaches far, in a world without direct light but ambient.
  world::Description description = classic();
  description.lights.clear();
  world::Material floor;
  floor.ambient.setConstant(0.5F);
  Stage stage;
  stage.addMesh(screen(50.0F, 0.0F),
                makePose({0, 1, 0},
                         Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitX()))),
                -1, floor);
  const cv::Mat picture = takePicture(description, stage);
  for (const int row : {28, 35, 48}) {
    EXPECT_NEAR(picture.at<cv::Vec3b>(row, 32)[1], 255 * 0.2, 1.0) << row;
  }
}

TEST(ClassicMaterial, ThatIsUnlitHasItsOwnColour) {
  world::Material material;
  material.lit = false;
  material.diffuse = {0.2F, 0.4F, 0.6F, 1.0F};
  expectColour(middle(classic(), material), 0.2, 0.4, 0.6);
}

TEST(ClassicMaterial, IsCutOffAtWhite) {
  world::Description description = classic();
  description.ambient.setOnes();
  expectColour(middle(description, {}), 1.0, 1.0, 1.0);
}

TEST(ClassicMaterial, OfABackIsLitByItsFrontsNormal) {
  world::Description description = classic();
  description.lights[0].direction_L = {0, 0, -1};  // towards the camera: onto the screen's front
  world::Material material;
  material.double_sided = true;
  auto turned = screen(1.0F, 2.0F);
  for (Eigen::Vector3f& normal : turned->normals) normal = -normal;
  turned->indices = {0, 2, 1, 0, 3, 2};
  Stage stage;
  stage.addMesh(turned, Pose::Identity(), 0, material);
  EXPECT_NEAR(takePicture(description, stage).at<cv::Vec3b>(24, 32)[1], 255 * 0.9, 1.0);
  description.lights[0].direction_L = {0, 0, 1};
  EXPECT_NEAR(takePicture(description, stage).at<cv::Vec3b>(24, 32)[1], 255 * 0.4, 1.0);
}

TEST(ClassicGlass, IsLitAsOthersAndMixedAsItIsEncoded) {
  world::Material material;
  material.ambient = {1.0F, 0.5F, 0.0F};
  material.diffuse = {0.2F, 0.4F, 0.6F, 0.5F};
  // Half of it, half of the background's 0.2.
  expectColour(middle(classic(), material), 0.5 * 0.5 + 0.1, 0.5 * 0.4 + 0.1, 0.5 * 0.3 + 0.1);
  material.ambient.setZero();
  material.diffuse = {0, 0, 0, 0.5F};
  material.specular = {1.0F, 0.4F, 0.0F};
  material.shininess = 20.0F;
  expectColour(middle(classic(), material), 0.5 * 0.5 + 0.1, 0.5 * 0.2 + 0.1, 0.1);
}

TEST(Overlay, IsSeenOnTheSurfaceThatHasIt) {
  auto lines = std::make_shared<world::Material>();
  lines->texture = halvedTexture({0, 0, 0, 0}, {255, 255, 255, 255});
  lines->texture_is_glass = true;
  lines->lit = false;
  world::Material grass;
  grass.ambient = {0.0F, 1.0F, 0.0F};
  grass.diffuse = {0.0F, 1.0F, 0.0F, 1.0F};
  grass.overlay = lines;
  Stage stage;
  stage.addMesh(screen(1.0F, 2.0F), Pose::Identity(), -1, grass);
  const cv::Mat picture = takePicture(classic(), stage);
  EXPECT_EQ(picture.at<cv::Vec3b>(24, 40), cv::Vec3b(255, 255, 255));
  EXPECT_NEAR(picture.at<cv::Vec3b>(24, 20)[1], 255 * 0.9, 1.0);
  EXPECT_EQ(picture.at<cv::Vec3b>(24, 20)[2], 0);
}

TEST(ClassicSky, LooksAsInGzSim) {
  world::Description description = classic();
  description.sky.emplace();
  const Stage nothing;
  const Pose upwards =
      makePose({0, 0, 0}, Eigen::Quaterniond(Eigen::AngleAxisd(-2.0, Eigen::Vector3d::UnitX())));
  for (const float exposure : {1.0F, 0.4F, 1.7F}) {
    const auto taken = [&](world::Simulator simulator) {
      description.simulator = simulator;
      Renderer renderer(description, nothing.links(), {});
      return renderer.colour({kSmallCamera, upwards}, {},
                             {{}, {}, Sampling::kCentre, {}, exposure});
    };
    cv::Mat difference;
    cv::absdiff(taken(world::Simulator::kClassic), taken(world::Simulator::kGz), difference);
    double most = 0.0;
    cv::minMaxLoc(difference.reshape(1), nullptr, &most);
    EXPECT_LE(most, 1.0);
  }
}

TEST(ClassicPicture, IsExposedInLinearLight) {
  Stage stage;
  stage.addMesh(screen(1.0F, 2.0F), Pose::Identity(), 0, {});
  Renderer renderer(classic(), stage.links(), {});
  const cv::Mat picture = renderer.colour({kSmallCamera, Pose::Identity()}, stage.poses(),
                                          {stage.all(), stage.all(), Sampling::kCentre, {}, 0.5F});
  const double light = 0.5 * std::pow((0.9 + 0.055) / 1.055, 2.4);
  const double wanted = 255.0 * (1.055 * std::pow(light, 1.0 / 2.4) - 0.055);
  EXPECT_NEAR(picture.at<cv::Vec3b>(24, 32)[1], wanted, 1.0);
}

}  // namespace classic_material_test
}  // namespace synthetic_dataset::render

/// The look of each material, pixel by pixel.

#include <cmath>

#include <gtest/gtest.h>

#include "render/picture_taking.h"
#include "render/renderer.h"

namespace synthetic_dataset::render {
namespace material_test {

using test::halvedTexture;
using test::kSmallCamera;
using test::plainTexture;
using test::screen;
using test::Stage;
using test::takePicture;

/// sRGB's encoding of linear light, as a channel value of a picture.
double encoded(double linear) {
  const double value =
      linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
  return 255.0 * value;
}

double decoded(double channel) {
  const double value = channel / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// A black world with one light that shines along `direction`.
world::Description litAlong(const Eigen::Vector3d& direction, float intensity = 1.0F) {
  world::Description description;
  description.simulator = world::Simulator::kGz;
  description.ambient.setZero();
  description.background.setZero();
  world::Light light;
  light.direction_L = direction.normalized();
  light.diffuse.setConstant(intensity);
  description.lights.push_back(light);
  return description;
}

/// A diffuse material, in linear light, without highlights.
world::Material matte(float channel) {
  world::Material material;
  material.diffuse = {channel, channel, channel, 1.0F};
  material.specular.setZero();
  material.roughness = 1.0F;
  return material;
}

Stage oneScreen(const world::Material& material, float half_width = 1.0F) {
  Stage stage;
  stage.addMesh(screen(half_width, 2.0F), Pose::Identity(), 0, material);
  return stage;
}

int green(const cv::Mat& image, int u = 32, int v = 24) { return image.at<cv::Vec3b>(v, u)[1]; }

/// A uniform normal map with a unit vector of the surface's own frame.
std::shared_ptr<world::Texture> normalMap(const Eigen::Vector3d& normal) {
  const Eigen::Vector3d rgb = 127.5 * (normal.array() + 1.0);
  return plainTexture({rgb.z(), rgb.y(), rgb.x(), 255});
}

/// The linear brightness of a half-grey screen with a normal map, lit by a single light.
double brightnessUnder(const Eigen::Vector3d& map_normal, const Eigen::Vector3d& light_direction) {
  world::Material material = matte(0.5F);
  if (!map_normal.isZero()) material.normal_map = normalMap(map_normal);
  return decoded(green(takePicture(litAlong(light_direction), oneScreen(material))));
}

TEST(Material, NormalsThatTiltToTheLightAreBrighterByLambertsLaw) {
  // Light comes from the right at 60 degrees to the surface's normal.
  const Eigen::Vector3d from_right(-std::sin(M_PI / 3), 0, std::cos(M_PI / 3));
  const double tilt = M_PI / 6;
  const double flat = brightnessUnder({0, 0, 0}, from_right);

  const double towards = brightnessUnder({std::sin(tilt), 0, std::cos(tilt)}, from_right);
  const double away = brightnessUnder({-std::sin(0.2), 0, std::cos(0.2)}, from_right);

  EXPECT_NEAR(towards / flat, std::cos(M_PI / 3 - tilt) / std::cos(M_PI / 3), 0.03);
  EXPECT_NEAR(away / flat, std::cos(M_PI / 3 + 0.2) / std::cos(M_PI / 3), 0.03);
}

TEST(Material, GreenOfNormalMapsIsUpTheTexture) {
  const Eigen::Vector3d from_above(0, std::sin(M_PI / 3), std::cos(M_PI / 3));  // +y is down
  const double flat = brightnessUnder({0, 0, 0}, from_above);

  const double up = brightnessUnder({0, std::sin(M_PI / 6), std::cos(M_PI / 6)}, from_above);

  EXPECT_NEAR(up / flat, std::cos(M_PI / 6) / std::cos(M_PI / 3), 0.03);
}

TEST(Material, NormalMapsOfMirroredTexturesAreMirroredToo) {
  const Eigen::Vector3d from_right(-std::sin(M_PI / 3), 0, std::cos(M_PI / 3));
  const double flat = brightnessUnder({0, 0, 0}, from_right);
  world::Material material = matte(0.5F);
  material.normal_map = normalMap({-std::sin(M_PI / 6), 0, std::cos(M_PI / 6)});
  material.texture_scale = {-1.0F, 1.0F};

  const cv::Mat image = takePicture(litAlong(from_right), oneScreen(material));

  EXPECT_NEAR(decoded(green(image)) / flat, std::cos(M_PI / 6) / std::cos(M_PI / 3), 0.03);
}

TEST(Material, NormalMapsWithoutTextureCoordinatesChangeNothing) {
  world::Material material = matte(0.5F);
  material.normal_map = normalMap(Eigen::Vector3d(1, 0, 1).normalized());
  auto mesh = screen(1.0F, 2.0F);
  mesh->texture_coordinates.clear();
  Stage stage;
  stage.addMesh(mesh, Pose::Identity(), 0, material);

  EXPECT_NEAR(green(takePicture(litAlong({0, 0, 1}), stage)), 128, 1);
}

TEST(Material, RoughnessMapsSpreadTheHighlight) {
  world::Material material = matte(0.0F);
  material.specular.setConstant(1.0F);
  material.roughness = 0.5F;
  const auto light = litAlong({0, 0, 1}, 0.5F);
  const double smooth = decoded(green(takePicture(light, oneScreen(material))));
  material.roughness = 1.0F;
  material.roughness_map = plainTexture({0, 128, 255, 255});  // 0.5, in green only

  const double mapped = decoded(green(takePicture(light, oneScreen(material))));
  material.roughness_map = plainTexture({0, 255, 0, 255});
  const double rough = decoded(green(takePicture(light, oneScreen(material))));

  EXPECT_NEAR(mapped, smooth, 0.02 * smooth + 0.002) << "the map times the value";
  // GGX head-on: the Fresnel term 0.16 times 1 / (4 alpha^2), with alpha the roughness squared.
  EXPECT_NEAR(rough, 0.5 * 0.16 * 0.25, 0.003);
  EXPECT_GT(smooth, 5.0 * rough);
}

TEST(Material, MetalnessMapsTakeTheDiffuseLightAway) {
  world::Material material = matte(0.5F);
  material.metalness = 1.0F;
  material.metalness_map = halvedTexture({0, 0, 0, 255}, {255, 0, 0, 255});
  // Light from far to the side, so that the metal's highlight is elsewhere.
  const cv::Mat image =
      takePicture(litAlong({-std::sin(1.2), 0, std::cos(1.2)}), oneScreen(material));

  const double linear = decoded(128);
  EXPECT_NEAR(green(image, 20), encoded(linear * std::cos(1.2)), 2.0);
  EXPECT_LT(decoded(green(image, 44)), 0.5 * decoded(green(image, 20)));
}

TEST(Material, EmissiveMapsGlowWithoutLight) {
  world::Material material = matte(0.5F);
  material.emissive = {1.0F, 1.0F, 1.0F};
  material.emissive_map = halvedTexture({0, 120, 0, 255}, {0, 0, 0, 255});
  world::Description dark = litAlong({0, 0, 1});
  dark.lights.clear();

  const cv::Mat image = takePicture(dark, oneScreen(material));

  EXPECT_NEAR(green(image, 20), 120, 1) << "decoded from sRGB and encoded again";
  EXPECT_EQ(green(image, 44), 0);
}

TEST(Material, UnlitShowsTheExactColour) {
  world::Material material = matte(1.0F);
  material.diffuse = {1.0F, 200.0F / 255.0F, 30.0F / 255.0F, 1.0F};
  material.lit = false;
  world::Description dark = litAlong({0, 0, 1});
  dark.lights.clear();

  EXPECT_EQ(takePicture(dark, oneScreen(material)).at<cv::Vec3b>(24, 32), cv::Vec3b(30, 200, 255));
}

TEST(Material, TextureScaleRepeatsTheTexture) {
  world::Material material = matte(1.0F);
  material.lit = false;
  material.texture = halvedTexture({0, 0, 0, 255}, {0, 255, 0, 255});
  material.texture_scale = {2.0F, 1.0F};

  const cv::Mat image = takePicture(litAlong({0, 0, 1}), oneScreen(material));

  // The screen spans the pixels 2 to 62: dark and bright quarters of 15.
  EXPECT_EQ(green(image, 9), 0);
  EXPECT_EQ(green(image, 24), 255);
  EXPECT_EQ(green(image, 39), 0);
  EXPECT_EQ(green(image, 54), 255);
}

TEST(Material, TextureOffsetMovesTheTexture) {
  world::Material material = matte(1.0F);
  material.lit = false;
  material.texture = halvedTexture({0, 0, 0, 255}, {0, 255, 0, 255});
  material.texture_offset = {0.5F, 0.0F};

  const cv::Mat image = takePicture(litAlong({0, 0, 1}), oneScreen(material));

  EXPECT_EQ(green(image, 18), 255);
  EXPECT_EQ(green(image, 46), 0);
}

TEST(Material, AlphaThresholdCutsColoursAndLabelsAlike) {
  world::Material material = matte(1.0F);
  material.lit = false;
  material.texture = halvedTexture({255, 255, 255, 60}, {255, 255, 255, 200});
  for (const auto& [threshold, left, right] :
       {std::tuple{0.1F, true, true}, {0.5F, false, true}, {0.9F, false, false}}) {
    material.alpha_threshold = threshold;
    const Stage stage = oneScreen(material);
    Renderer renderer(litAlong({0, 0, 1}), stage.links(), {});

    const cv::Mat image =
        renderer.colour({kSmallCamera}, stage.poses(), {stage.all(), stage.all()});
    const cv::Mat ids = renderer.labels({kSmallCamera}, stage.poses(), {stage.all()}).ids;

    EXPECT_EQ(green(image, 20), left ? 255 : 0) << threshold;
    EXPECT_EQ(green(image, 44), right ? 255 : 0) << threshold;
    EXPECT_EQ(ids.at<int>(24, 20), left ? 1 : 0) << threshold;
    EXPECT_EQ(ids.at<int>(24, 44), right ? 1 : 0) << threshold;
  }
}

TEST(Material, AlphaThresholdCutsShadowsAlike) {
  world::Material material = matte(1.0F);
  material.texture = halvedTexture({255, 255, 255, 60}, {255, 255, 255, 200});
  world::Description description = litAlong({0, 0, 1});
  description.lights[0].casts_shadow = true;
  description.ambient.setConstant(0.1F);
  // The screen is behind the camera and throws its shadow on a wall before it.
  Stage stage;
  stage.addMesh(screen(1.0F, -1.0F), Pose::Identity(), 0, material);
  stage.addMesh(screen(5.0F, 3.0F), Pose::Identity(), -1, matte(0.7F));

  const cv::Mat image = takePicture(description, stage);

  EXPECT_LT(green(image, 42), 60) << "the right half casts";
  EXPECT_GT(green(image, 22), 150) << "the left half is a hole";
}

TEST(Material, GlassTexturesBlendInLinearLight) {
  world::Material material = matte(1.0F);
  material.lit = false;
  material.texture = plainTexture({255, 255, 255, 102});  // 0.4
  material.texture_is_glass = true;

  const cv::Mat image = takePicture(litAlong({0, 0, 1}), oneScreen(material));

  EXPECT_NEAR(green(image), encoded(0.4), 1.0);
}

TEST(Material, VertexColoursMultiplyTheDiffuseColour) {
  world::Material material = matte(1.0F);
  material.lit = false;
  auto mesh = screen(1.0F, 2.0F);
  mesh->colours.assign(4, {0.2F, 0.6F, 1.0F, 1.0F});
  Stage stage;
  stage.addMesh(mesh, Pose::Identity(), 0, material);

  const auto pixel = takePicture(litAlong({0, 0, 1}), stage).at<cv::Vec3b>(24, 32);

  EXPECT_EQ(pixel, cv::Vec3b(255, 153, 51));
}

TEST(Material, VertexAlphaBlendsALayerOnTheSameTriangles) {
  world::Material white = matte(1.0F);
  white.lit = false;
  world::Material black = matte(0.0F);
  black.lit = false;
  auto layer = screen(1.0F, 2.0F);
  layer->colours.assign(4, {1.0F, 1.0F, 1.0F, 0.5F});
  Stage stage;
  stage.addMesh(layer, Pose::Identity(), -1, white);
  stage.addMesh(screen(1.0F, 2.0F), Pose::Identity(), -1, black);
  // Turned, so that depth is not the same everywhere.
  const Pose X_WL = makePose({0.1, 0, 0.3}, Eigen::Quaterniond(0.98, 0.1, 0.15, 0.05).normalized());
  stage.poses() = {X_WL, X_WL};

  const cv::Mat image = takePicture(litAlong({0, 0, 1}), stage);

  for (int u = 30; u < 60; ++u) EXPECT_NEAR(green(image, u), encoded(0.5), 1.0) << u;
}

TEST(Material, DoubleSidedSurfacesAreLitOnTheSideThatIsSeen) {
  world::Material material = matte(0.5F);
  material.double_sided = true;
  auto turned = screen(1.0F, 2.0F);
  for (auto& normal : turned->normals) normal = -normal;
  turned->indices = {0, 2, 1, 0, 3, 2};
  Stage stage;
  stage.addMesh(turned, Pose::Identity(), 0, material);

  EXPECT_NEAR(green(takePicture(litAlong({0, 0, 1}), stage)), 128, 1)
      << "light from the eye's side";
  EXPECT_EQ(green(takePicture(litAlong({0, 0, -1}), stage)), 0) << "light from behind";
}

}  // namespace material_test
}  // namespace synthetic_dataset::render

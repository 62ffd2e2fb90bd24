#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "render/picture_taking.h"
#include "render/renderer.h"
#include "support/box_world.h"
#include "support/random_poses.h"

namespace synthetic_dataset::render {
namespace silhouette_test {

using test::Stage;

constexpr double kFocalLength = 200.0;
const CameraModel kCamera(320, 240, {kFocalLength, kFocalLength, 159.5, 119.5}, 0.05, 100.0);

/// A plate before the camera whose outline is a box of the image.
void addPlate(Stage& stage, const Box& outline, int object, double depth = 2.0,
              const world::Material& material = {}) {
  constexpr double kThickness = 1e-4;
  const Intrinsics& k = kCamera.intrinsics();
  const double metres = depth / kFocalLength;  // per pixel at this depth
  const double x = 0.5 * (outline.left + outline.right) - k.cx;
  const double y = 0.5 * (outline.top + outline.bottom) - k.cy;
  stage.addBox(
      {outline.width() * metres, outline.height() * metres, kThickness},
      makePose({x * metres, y * metres, depth + 0.5 * kThickness}, Eigen::Quaterniond::Identity()),
      object, material);
}

Silhouette silhouetteOf(const Stage& stage, const CameraModel& camera = kCamera) {
  Renderer renderer({}, stage.links(), {});
  return renderer.silhouette({camera, Pose::Identity()}, stage.poses(), stage.all());
}

void expectBox(const std::optional<Box>& found, const Box& wanted, double tolerance = 0.0) {
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->left, wanted.left, tolerance);
  EXPECT_NEAR(found->top, wanted.top, tolerance);
  EXPECT_NEAR(found->right, wanted.right, tolerance);
  EXPECT_NEAR(found->bottom, wanted.bottom, tolerance);
}

TEST(Silhouette, HasThePixelsWhoseCentresAreOnTheObject) {
  Stage stage;
  addPlate(stage, {99.5, 49.5, 139.5, 79.5}, 0);

  const Silhouette silhouette = silhouetteOf(stage);

  EXPECT_EQ(silhouette.pixels, 40 * 30);
  EXPECT_EQ(silhouette.pixels_in_image, 40 * 30);
  expectBox(silhouette.box, {99.5, 49.5, 139.5, 79.5});
  cv::Mat wanted = cv::Mat::zeros(240, 320, CV_8UC1);
  wanted(cv::Rect(100, 50, 40, 30)).setTo(255);
  EXPECT_EQ(cv::norm(silhouette.mask.whole(), wanted, cv::NORM_INF), 0.0);
}

struct EdgeCase {
  const char* name;
  Box outline;
  int in_image;
};

class SilhouetteAtTheEdge : public ::testing::TestWithParam<EdgeCase> {};

TEST_P(SilhouetteAtTheEdge, IsCountedPastIt) {
  const EdgeCase& edge = GetParam();
  Stage stage;
  addPlate(stage, edge.outline, 0);

  const Silhouette silhouette = silhouetteOf(stage);

  EXPECT_EQ(silhouette.pixels, std::llround(edge.outline.width() * edge.outline.height()));
  EXPECT_EQ(silhouette.pixels_in_image, edge.in_image);
  EXPECT_EQ(silhouette.mask.count(), edge.in_image);
  expectBox(silhouette.box, edge.outline);
}

INSTANTIATE_TEST_SUITE_P(
    Places, SilhouetteAtTheEdge,
    ::testing::Values(EdgeCase{"left", {-20.5, 49.5, 19.5, 79.5}, 600},
                      EdgeCase{"right", {309.5, 49.5, 349.5, 79.5}, 300},
                      EdgeCase{"top", {99.5, -25.5, 139.5, 4.5}, 200},
                      EdgeCase{"bottom", {99.5, 229.5, 139.5, 259.5}, 400},
                      EdgeCase{"corner", {-30.5, -10.5, 9.5, 19.5}, 200},
                      EdgeCase{"opposite_corner", {315.5, 235.5, 330.5, 250.5}, 16},
                      EdgeCase{"both_sides", {-100.5, 99.5, 419.5, 109.5}, 3200},
                      EdgeCase{"all_round", {-100.5, -100.5, 419.5, 339.5}, 320 * 240},
                      EdgeCase{"beside", {399.5, 99.5, 439.5, 129.5}, 0},
                      EdgeCase{"above_and_beside", {-139.5, -99.5, -99.5, -69.5}, 0}),
    [](const auto& each) { return each.param.name; });

TEST(Silhouette, IsCountedFartherThanAnImagesWidthAway) {
  Stage stage;
  addPlate(stage, {399.5, 99.5, 899.5, 199.5}, 0);

  const Silhouette silhouette = silhouetteOf(stage);

  EXPECT_EQ(silhouette.pixels_in_image, 0);
  EXPECT_EQ(silhouette.pixels, 500 * 100);
  expectBox(silhouette.box, {399.5, 99.5, 899.5, 199.5});
}

TEST(Silhouette, IsNothingBehindTheCamera) {
  Stage stage;
  stage.addBox({1, 1, 1}, makePose({0, 0, -3}, Eigen::Quaterniond::Identity()), 0);

  const Silhouette silhouette = silhouetteOf(stage);

  EXPECT_EQ(silhouette.pixels, 0);
  EXPECT_FALSE(silhouette.box);
  EXPECT_TRUE(silhouette.mask.empty());
}

TEST(Silhouette, FillsEverythingFromInsideOfABox) {
  world::Material wall;
  wall.double_sided = true;
  Stage stage;
  stage.addBox({2, 2, 2}, Pose::Identity(), 0, wall);

  const Silhouette silhouette = silhouetteOf(stage);

  // The walls reach to the near plane, where they are 1 m off the axis.
  const double reach = kFocalLength * 1.0 / kCamera.near();
  EXPECT_EQ(silhouette.pixels_in_image, 320 * 240);
  EXPECT_NEAR(static_cast<double>(silhouette.pixels), 4.0 * reach * reach,
              0.005 * 4 * reach * reach);
  expectBox(silhouette.box, {159.5 - reach, 119.5 - reach, 159.5 + reach, 119.5 + reach}, 16.0);
}

TEST(Silhouette, OfWhatPassesUnderTheCameraIsAsLargeAsGeometrySays) {
  // A strip 0.5 m below the axis, from behind the camera to 5 m ahead. At depth z its half width is
  // f w / z pixels, and it lies s = f h / z below the centre: a triangle with its tip cut off.
  constexpr double kHeight = 0.5;
  constexpr double kHalfWidth = 0.25;
  Stage stage;
  stage.addBox({2 * kHalfWidth, 1e-4, 6.0},
               makePose({0, kHeight + 0.5e-4, 2.0}, Eigen::Quaterniond::Identity()), 0);

  const Silhouette silhouette = silhouetteOf(stage);

  const auto area = [](double from, double to) {
    return kHalfWidth / kHeight * (to * to - from * from);
  };
  const double first = kFocalLength * kHeight / 5.0;
  const double last = kFocalLength * kHeight / kCamera.near();
  const double in_image = area(first, 239.5 - 119.5);
  EXPECT_NEAR(static_cast<double>(silhouette.pixels_in_image), in_image, 0.01 * in_image);
  EXPECT_NEAR(static_cast<double>(silhouette.pixels), area(first, last), 0.005 * area(first, last));
  const double truncation = 1.0 - static_cast<double>(silhouette.pixels_in_image) /
                                      static_cast<double>(silhouette.pixels);
  EXPECT_NEAR(truncation, 1.0 - in_image / area(first, last), 1e-4);
  EXPECT_NEAR(silhouette.box->bottom, 119.5 + last, 3.0);
}

TEST(Silhouette, CanBeOnePixel) {
  Stage stage;
  addPlate(stage, {99.7, 49.7, 100.3, 50.3}, 0);

  const Silhouette silhouette = silhouetteOf(stage);

  EXPECT_EQ(silhouette.pixels, 1);
  EXPECT_TRUE(silhouette.mask.at({100, 50}));
  expectBox(silhouette.box, {99.5, 49.5, 100.5, 50.5});
}

TEST(Silhouette, IsNothingBetweenPixelCentres) {
  Stage stage;
  addPlate(stage, {100.2, 49.0, 100.8, 51.0}, 0);

  EXPECT_EQ(silhouetteOf(stage).pixels, 0);
  EXPECT_FALSE(silhouetteOf(stage).box);
}

TEST(Silhouette, TellsManyObjectsApart) {
  constexpr int kColumns = 20;
  constexpr int kCount = 300;
  Stage stage;
  for (int i = 0; i < kCount; ++i) {
    const double left = 10.0 + 12 * (i % kColumns) - 0.5;
    const double top = 10.0 + 12 * (i / kColumns) - 0.5;
    addPlate(stage, {left, top, left + 4 + i % 5, top + 4}, i);
  }
  Renderer renderer({}, stage.links(), {});
  const View view{kCamera, Pose::Identity()};
  const cv::Mat ids = renderer.labels(view, stage.poses(), {stage.all()}).ids;

  for (int i = 0; i < kCount; ++i) {
    LinkSelection alone(kCount, false);
    alone[static_cast<std::size_t>(i)] = true;
    const Silhouette silhouette = renderer.silhouette(view, stage.poses(), alone);
    EXPECT_EQ(silhouette.pixels, 4 * (4 + i % 5)) << i;
    EXPECT_EQ(cv::norm(silhouette.mask.whole(), ids == i + 1, cv::NORM_INF), 0.0) << i;
  }
}

TEST(Silhouette, IsWholeBehindAFrameThatHidesPartOfIt) {
  Stage stage;
  addPlate(stage, {79.5, 79.5, 199.5, 159.5}, 0);
  const Box bars[] = {{69.5, 69.5, 209.5, 99.5},
                      {69.5, 139.5, 209.5, 169.5},
                      {69.5, 99.5, 109.5, 139.5},
                      {169.5, 99.5, 209.5, 139.5}};
  for (const Box& bar : bars) addPlate(stage, bar, 1, 1.0);
  Renderer renderer({}, stage.links(), {});
  const View view{kCamera, Pose::Identity()};

  const cv::Mat ids = renderer.labels(view, stage.poses(), {stage.all()}).ids;
  const Silhouette plate =
      renderer.silhouette(view, stage.poses(), {true, false, false, false, false});
  const Silhouette frame =
      renderer.silhouette(view, stage.poses(), {false, true, true, true, true});

  EXPECT_EQ(cv::countNonZero(ids == 1), 60 * 40);
  EXPECT_EQ(plate.pixels, 120 * 80);
  EXPECT_EQ(frame.pixels, 140 * 100 - 60 * 40);
  expectBox(frame.box, {69.5, 69.5, 209.5, 169.5});
  EXPECT_FALSE(frame.mask.at({139, 119})) << "the hole";
}

TEST(Silhouette, HasTheHolesOfItsPicture) {
  world::Material fence;
  fence.texture = test::halvedTexture({255, 255, 255, 0}, {255, 255, 255, 255});
  Stage stage;
  // At depth 3 a metre is 20 pixels of the small camera.
  stage.addMesh(test::screen(1.025F, 3.0F), Pose::Identity(), 0, fence);

  const Silhouette silhouette = silhouetteOf(stage, test::kSmallCamera);

  EXPECT_NEAR(static_cast<double>(silhouette.pixels), 0.5 * 41 * 41, 41) << "the right half";
  EXPECT_FALSE(silhouette.mask.at({25, 24}));
  EXPECT_TRUE(silhouette.mask.at({40, 24}));
}

TEST(Silhouette, LeavesOutTheWorldsGlassAsLabelsDo) {
  world::Material glass;
  glass.diffuse.w() = 0.3F;
  Stage stage;
  addPlate(stage, {9.5, 9.5, 19.5, 19.5}, -1, 2.0, glass);
  addPlate(stage, {49.5, 9.5, 59.5, 19.5}, 0, 2.0, glass);

  EXPECT_EQ(silhouetteOf(stage).pixels, 100) << "an object's counts";
}

TEST(Silhouette, IsWhatLabelsShowOfTheObjectAlone) {
  std::mt19937 random(4);
  Stage stage;
  constexpr int kObjects = 30;
  for (int i = 0; i < kObjects; ++i) {
    stage.addBox({0.5, 0.3, 0.4},
                 makePose(Eigen::Vector3d(0, 0, 3) + test::randomPoint(random, 2.5),
                          test::randomOrientation(random)),
                 i);
  }
  Renderer renderer({}, stage.links(), {});
  const View view{kCamera, Pose::Identity()};
  for (std::size_t i = 0; i < kObjects; ++i) {
    LinkSelection alone(kObjects, false);
    alone[i] = true;

    const Silhouette silhouette = renderer.silhouette(view, stage.poses(), alone);
    const cv::Mat labels = renderer.labels(view, stage.poses(), {alone}).ids > 0;

    EXPECT_EQ(cv::norm(silhouette.mask.whole(), labels, cv::NORM_INF), 0.0) << i;
    EXPECT_EQ(silhouette.pixels_in_image, cv::countNonZero(labels)) << i;
  }
}

}  // namespace silhouette_test
}  // namespace synthetic_dataset::render

#include <array>
#include <utility>

#include <gtest/gtest.h>

#include "render/renderer.h"
#include "support/box_world.h"

namespace synthetic_dataset::render {
namespace glass_in_labels_test {

using test::Stage;

/// A lens with practically no distortion that still takes the code path with a ray for each pixel.
const Distortion kSlight{DistortionModel::kPlumbBob, {1e-9, 0.0, 0.0, 0.0, 0.0}};

/// On the left an object behind a pane that belongs to the world, on the right an object behind the
/// window of another object.
class GlassInLabelsTest : public testing::TestWithParam<bool> {
 protected:
  GlassInLabelsTest() {
    world::Material glass;
    glass.diffuse.w() = 0.3F;
    addPlate(-0.5, 2.0, -1, glass);
    addPlate(-0.5, 3.0, 0);
    addPlate(0.5, 2.0, 1, glass);
    addPlate(0.5, 3.0, 2);
  }

  /// Adds a plate of 0.9 m whose front is at this distance.
  void addPlate(double x, double distance, int object, const world::Material& material = {}) {
    constexpr double kThickness = 0.01;
    stage_.addBox({0.9, 0.9, kThickness},
                  makePose({x, 0.0, distance + 0.5 * kThickness}, Eigen::Quaterniond::Identity()),
                  object, material);
  }

  /// The id and the depth that labels show at the pane and at the window.
  [[nodiscard]] std::array<std::pair<int, float>, 2> seen(GlassInLabels glass) const {
    RenderOptions options;
    options.glass_in_labels = glass;
    const Intrinsics k{200.0, 200.0, 159.5, 119.5};
    const CameraModel camera = GetParam() ? CameraModel(320, 240, k, 0.05, 100.0, kSlight)
                                          : CameraModel(320, 240, k, 0.05, 100.0);
    Renderer renderer({}, stage_.links(), options);
    const LabelImages labels =
        renderer.labels({camera, Pose::Identity()}, stage_.poses(), {stage_.all()});
    std::array<std::pair<int, float>, 2> found;
    const std::array<cv::Point, 2> pixels = {cv::Point(120, 120), cv::Point(200, 120)};
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      found[i] = {labels.ids.at<int>(pixels[i]), labels.depth.at<float>(pixels[i])};
    }
    return found;
  }

  static void expect(const std::pair<int, float>& seen, int id, float depth) {
    EXPECT_EQ(seen.first, id);
    EXPECT_NEAR(seen.second, depth, 1e-4);
  }

  Stage stage_;
};

TEST_P(GlassInLabelsTest, IsThatOfObjects) {
  const auto found = seen(GlassInLabels::kOfObjects);
  expect(found[0], 1, 3.0F);
  expect(found[1], 2, 2.0F);
}

TEST_P(GlassInLabelsTest, MayBeSolid) {
  const auto found = seen(GlassInLabels::kSolid);
  expect(found[0], 0, 2.0F);
  expect(found[1], 2, 2.0F);
}

TEST_P(GlassInLabelsTest, MayBeClear) {
  const auto found = seen(GlassInLabels::kClear);
  expect(found[0], 1, 3.0F);
  expect(found[1], 3, 3.0F);
}

INSTANTIATE_TEST_SUITE_P(ThroughALens, GlassInLabelsTest, testing::Bool());

/// A plate 2 m away with a blended texture that is clear on the left and has a given alpha on the
/// right; behind it is object 5.
class BlendedPlate : public testing::TestWithParam<bool> {
 protected:
  /// The ids on the left and on the right.
  [[nodiscard]] static std::array<int, 2> seen(int object, std::uint8_t alpha,
                                               GlassInLabels glass) {
    auto texture = std::make_shared<world::Texture>();
    texture->pixels = cv::Mat(8, 8, CV_8UC4, cv::Scalar(255, 255, 255, 0));
    texture->pixels.colRange(4, 8).setTo(cv::Scalar(255, 255, 255, alpha));
    world::Material leaf;
    leaf.texture = texture;
    leaf.texture_is_glass = true;
    auto plate = std::make_shared<world::Mesh>();
    plate->positions = {{-0.5F, -0.5F, 2}, {0.5F, -0.5F, 2}, {0.5F, 0.5F, 2}, {-0.5F, 0.5F, 2}};
    plate->normals.assign(4, {0, 0, -1});
    plate->texture_coordinates = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    plate->indices = {0, 2, 1, 0, 3, 2};
    Stage stage;
    stage.addMesh(plate, Pose::Identity(), object, leaf);
    stage.addBox({2, 2, 0.01}, makePose({0, 0, 3}, Eigen::Quaterniond::Identity()), 5, {});
    RenderOptions options;
    options.glass_in_labels = glass;
    const Intrinsics k{200.0, 200.0, 159.5, 119.5};
    const CameraModel camera = GetParam() ? CameraModel(320, 240, k, 0.05, 100.0, kSlight)
                                          : CameraModel(320, 240, k, 0.05, 100.0);
    Renderer renderer({}, stage.links(), options);
    const LabelImages labels =
        renderer.labels({camera, Pose::Identity()}, stage.poses(), {stage.all()});
    return {labels.ids.at<int>(120, 140), labels.ids.at<int>(120, 180)};
  }
};

TEST_P(BlendedPlate, HasNoLabelsWhereItIsClear) {
  EXPECT_EQ(seen(0, 255, GlassInLabels::kOfObjects), (std::array<int, 2>{6, 1}));
  EXPECT_EQ(seen(0, 64, GlassInLabels::kOfObjects), (std::array<int, 2>{6, 1}));
  EXPECT_EQ(seen(0, 12, GlassInLabels::kOfObjects), (std::array<int, 2>{6, 6}));
}

TEST_P(BlendedPlate, OfTheWorldHidesWhereItIsOpaque) {
  EXPECT_EQ(seen(-1, 255, GlassInLabels::kOfObjects), (std::array<int, 2>{6, 0}));
  EXPECT_EQ(seen(-1, 128, GlassInLabels::kOfObjects), (std::array<int, 2>{6, 6}));
  EXPECT_EQ(seen(0, 128, GlassInLabels::kClear), (std::array<int, 2>{6, 6}));
}

INSTANTIATE_TEST_SUITE_P(ThroughALens, BlendedPlate, testing::Bool());

}  // namespace glass_in_labels_test
}  // namespace synthetic_dataset::render

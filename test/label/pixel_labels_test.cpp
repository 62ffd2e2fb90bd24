#include <memory>
#include <optional>
#include <thread>

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include "run/setup/run_setup.h"
#include "scene/camera_poses.h"
#include "scene/object_motion.h"
#include "scene/scene_maker.h"
#include "support/bag_builder.h"
#include "support/tiny_run.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::label {
namespace pixel_labels_test {

/// The tiny run with its two boxes of 0.4 m where a test puts them. The camera looks along +x from
/// (-3, 0.2, 0.5), f = 140 px, its centre at (79.5, 59.5).
class PixelLabels : public testing::Test {
 protected:
  static void SetUpTestSuite() { test::preparePluginEnvironment(); }

  /// @param change  settings to replace
  void place(const Pose& X_GA, const Pose& X_GB, const Value::Map& change = {}) {
    test::BagBuilder(run_.folder() / "placed.bag")
        .move("map", "alpha/base_link", test::milliseconds(1000), X_GA)
        .move("map", "bravo/base_link", test::milliseconds(1000), X_GB)
        .move("map", "alpha/base_link", test::milliseconds(2000), test::poseAt(0, 5, 0))
        .move("map", "bravo/base_link", test::milliseconds(2000), X_GB)
        .close();
    Value::Map parameters = run_.parameters();
    parameters.erase("background_subtractor");
    parameters["bag_file"] = Value((run_.folder() / "placed.bag").string());
    for (const auto& [name, value] : change) parameters[name] = value;
    whole_ = run::setUpRun(Value(parameters), {test::pluginXml()});
    setup_ = &whole_.motions.front();
  }

  /// The first scene with what these requirements ask for.
  Scene sceneWith(const Requirements& requirements) {
    maker_.reset();
    renderer_.reset();
    renderer_ = std::make_unique<render::Renderer>(setup_->world->description(),
                                                   setup_->world->links(), render::RenderOptions{});
    motion_ = std::make_unique<scene::ObjectMotion>(*setup_->frames, setup_->config.objects,
                                                    setup_->world->links(), setup_->driven_links);
    maker_ = std::make_unique<scene::SceneMaker>(*setup_->world, *renderer_, *setup_->frames,
                                                 setup_->cameras, *setup_->shapes, requirements,
                                                 PixelLabelOptions{setup_->config.masks,
                                                                   setup_->config.labels,
                                                                   {1, 1},
                                                                   setup_->world_classes,
                                                                   setup_->parts});
    moveTo(0);
    scene::CameraPoses poses = posesAt(0);
    seen_ = maker_->look(0, 0, stamp(0), poses, motion_->objectPoses(stamp(0)));
    agreement_ = seen_->pixels.labels(seen_->scene, {}).agreement;
    return seen_->scene;
  }

  [[nodiscard]] Stamp stamp(std::size_t i) const { return setup_->timeline.stamps.at(i); }

  [[nodiscard]] scene::CameraPoses posesAt(std::size_t i) const {
    return {setup_->cameras, *setup_->world, *setup_->frames, stamp(i)};
  }

  void moveTo(std::size_t i) {
    setup_->world->advanceTo(stamp(i),
                             [this](int object, Stamp time) { return motion_->at(object, time); });
  }

  test::TinyRun run_;
  run::RunSetup whole_;
  run::MotionSetup* setup_ = nullptr;
  std::unique_ptr<render::Renderer> renderer_;
  std::unique_ptr<scene::ObjectMotion> motion_;
  std::unique_ptr<scene::SceneMaker> maker_;
  std::optional<scene::SeenScene> seen_;
  MaskAgreement agreement_;
};

Requirements everything() {
  Requirements all;
  all.silhouettes = all.visible_masks = all.visibility = all.keypoint_states = true;
  all.class_map = all.depth = all.normals = true;
  return all;
}

Value methodOf(const char* method) { return Value(Value::Map{{"method", Value(method)}}); }

constexpr double kAxis = 0.2;  // the y of the camera's optical axis

TEST_F(PixelLabels, AnObjectInTheOpenIsAllVisible) {
  place(test::poseAt(0, kAxis, 0), test::poseAt(0, 5, 0));
  const Scene scene = sceneWith(everything());
  const SceneObject& alpha = scene.objects[0];
  // Its front face is 2.8 m away: 0.4 m are 20 px. Seen from above, its top face shows as well.
  ASSERT_TRUE(alpha.visibleBox());
  EXPECT_NEAR(alpha.visibleBox()->left, 79.5 - 10.0, 0.5);
  EXPECT_NEAR(alpha.visibleBox()->right, 79.5 + 10.0, 0.5);
  EXPECT_NEAR(alpha.visibleBox()->bottom, 59.5 + 0.5 / 2.8 * 140, 0.5);
  EXPECT_NEAR(alpha.visibleBox()->top, 59.5 + 0.1 / 3.2 * 140, 0.5);
  EXPECT_EQ(alpha.visibility(), 1.0);
  EXPECT_EQ(alpha.truncation(), 0.0);
  EXPECT_EQ(alpha.pixels.visible(), alpha.visible_mask().count());
  EXPECT_EQ(cv::countNonZero(alpha.visible_mask().whole() != alpha.silhouette().whole()), 0);
  EXPECT_TRUE(alpha.labelled());
}

TEST_F(PixelLabels, ShowClassesOfTheWorldAndPartsOfObjects) {
  Value::Map alpha = test::TinyRun::object("alpha");
  alpha["parts"] = Value(Value::Map{{"all", Value(Value::List{Value("bo*")})}});
  const Value classes(Value::Map{{"ground", Value(Value::List{Value("floor")})},
                                 {"toy", Value(Value::List{Value("ball")})}});
  place(test::poseAt(0, kAxis, 0), test::poseAt(0.5, kAxis - 0.6, 0),
        {{"world_classes", classes}, {"alpha", Value(alpha)}});
  Requirements maps;
  maps.world_map = maps.part_map = maps.visible_masks = true;
  const Scene scene = sceneWith(maps);
  EXPECT_EQ(scene.world_map().at<std::uint16_t>(115, 5), 1);
  EXPECT_EQ(scene.world_map().at<std::uint16_t>(5, 5), 0);  // the sky
  EXPECT_GT(cv::countNonZero(scene.world_map() == 2), 10);
  const cv::Mat objects = scene.instance_map() != 0;
  EXPECT_EQ(cv::countNonZero(objects & (scene.world_map() != 0)), 0);
  EXPECT_GT(scene.objects[1].visible_mask().count(), 100);
  EXPECT_EQ(cv::countNonZero((scene.part_map() == 1) != scene.objects[0].visible_mask().whole()),
            0);
}

TEST_F(PixelLabels, AMaskReachesBeyondABoundingShapeThatIsTooSmall) {
  Value::Map alpha = test::TinyRun::object("alpha");
  const Value corner(Value::List{Value(0.1), Value(0.1), Value(0.1)});
  alpha["bounding_shape"] =
      Value(Value::List{corner, Value(Value::List{Value(-0.1), Value(-0.1), Value(0.3)})});
  place(test::poseAt(0, kAxis, 0), test::poseAt(0, 5, 0),
        {{"masks", methodOf("mog2")}, {"alpha", Value(alpha)}});
  const cv::Mat by_subtraction = sceneWith(everything()).objects[0].silhouette().whole();
  place(test::poseAt(0, kAxis, 0), test::poseAt(0, 5, 0), {{"masks", methodOf("exact")}});
  const cv::Mat exact = sceneWith(everything()).objects[0].silhouette().whole();
  ASSERT_GT(cv::countNonZero(exact), 400);
  EXPECT_LT(cv::countNonZero(by_subtraction != exact), 20);
}

TEST_F(PixelLabels, AreTheSameWhenTheyAreFoundLaterInAnotherOrder) {
  place(test::poseAt(0, kAxis, 0), test::poseAt(0.5, kAxis - 0.3, 0),
        {{"masks", methodOf("mog2")}});
  const Scene at_once = sceneWith(everything());
  place(test::poseAt(0, kAxis, 0), test::poseAt(0.5, kAxis - 0.3, 0),
        {{"masks", methodOf("mog2")}});
  (void)sceneWith(everything());
  const auto look = [&](std::size_t i) {
    moveTo(i);
    scene::CameraPoses poses = posesAt(i);
    return maker_->look(0, static_cast<std::int64_t>(i), stamp(i), poses,
                        motion_->objectPoses(stamp(i)));
  };
  std::vector<scene::SeenScene> later = {look(0), look(1), look(2)};
  for (const std::size_t i : {2U, 1U, 0U}) {
    std::thread([&] { (void)later[i].pixels.labels(later[i].scene, {}); }).join();
  }
  const Scene& again = later[0].scene;
  EXPECT_EQ(cv::norm(again.instance_map(), at_once.instance_map(), cv::NORM_INF), 0.0);
  for (std::size_t i = 0; i < at_once.objects.size(); ++i) {
    EXPECT_GT(again.objects[i].silhouette().count(), 100);
    EXPECT_EQ(cv::norm(again.objects[i].silhouette().whole(),
                       at_once.objects[i].silhouette().whole(), cv::NORM_INF),
              0);
    EXPECT_EQ(again.objects[i].pixels.visible(), at_once.objects[i].pixels.visible());
  }
}

TEST_F(PixelLabels, AnObjectOutOfViewIsNotLabelled) {
  place(test::poseAt(0, kAxis, 0), test::poseAt(0, 5, 0));
  const SceneObject bravo = sceneWith(everything()).objects[1];
  EXPECT_EQ(bravo.pixels.visible(), 0);
  EXPECT_FALSE(bravo.visibleBox());
  EXPECT_EQ(bravo.truncation(), 1.0);
  EXPECT_FALSE(bravo.labelled());
}

TEST_F(PixelLabels, AnObjectBehindAnotherIsHidden) {
  place(test::poseAt(0, kAxis, 0), test::poseAt(0.5, kAxis, -0.2));
  const Scene scene = sceneWith(everything());
  const SceneObject& bravo = scene.objects[1];
  EXPECT_GT(bravo.silhouette().count(), 100);
  EXPECT_EQ(bravo.pixels.visible(), 0);
  EXPECT_EQ(bravo.visibility(), 0.0);
  EXPECT_FALSE(bravo.labelled());
  for (const Keypoint& keypoint : bravo.keypoints) {
    EXPECT_EQ(keypoint.state(), KeypointState::kHiddenByAnother);
  }
}

TEST_F(PixelLabels, AnObjectHalfBehindAnotherIsHalfVisible) {
  // Alpha floats a bit, so that bravo, 1 m behind, does not show above it. Bravo begins 0.07 m
  // right of the axis, 3.8 m away, and ends 0.47 m right of it; alpha hides what is left of 0.2
  // m, 2.8 m away.
  place(test::poseAt(0, kAxis, 0.1), test::poseAt(1.0, kAxis - 0.27, 0));
  const Scene scene = sceneWith(everything());
  const SceneObject& alpha = scene.objects[0];
  const SceneObject& bravo = scene.objects[1];
  EXPECT_EQ(alpha.visibility(), 1.0);
  EXPECT_GT(bravo.visibility(), 0.4);
  EXPECT_LT(bravo.visibility(), 0.7);
  EXPECT_NEAR(bravo.visibleBox()->left, alpha.visibleBox()->right, 1.01);
  EXPECT_EQ(cv::countNonZero(alpha.visible_mask().whole() & bravo.visible_mask().whole()), 0);
  EXPECT_GT(cv::countNonZero(alpha.visible_mask().whole() & bravo.silhouette().whole()), 0);
}

TEST_F(PixelLabels, VisibleMasksAreThePartsOfTheInstanceMap) {
  place(test::poseAt(0, kAxis, 0.1), test::poseAt(1.0, kAxis - 0.27, 0));
  const Scene scene = sceneWith(everything());
  for (const SceneObject& object : scene.objects) {
    EXPECT_EQ(cv::countNonZero((scene.instance_map() == object.instance) !=
                               object.visible_mask().whole()),
              0);
  }
  EXPECT_EQ(cv::countNonZero((scene.instance_map() != 0) != (scene.class_map() == 1)), 0);
}

TEST_F(PixelLabels, SubtractionIsLayeredLikeTheExactMasks) {
  const Pose X_GA = test::poseAt(0, kAxis, 0.1);
  const Pose X_GB = test::poseAt(1.0, kAxis - 0.27, 0);
  place(X_GA, X_GB);
  const Scene exact = sceneWith(everything());
  place(X_GA, X_GB, {{"masks", methodOf("mog2")}});
  const Scene found = sceneWith(everything());
  for (std::size_t i = 0; i < 2; ++i) {
    const cv::Mat a = exact.objects[i].visible_mask().whole();
    const cv::Mat b = found.objects[i].visible_mask().whole();
    EXPECT_GT(cv::countNonZero(a & b), 0.9 * cv::countNonZero(a | b)) << i;
    // The measures are exact with either kind of mask.
    EXPECT_EQ(found.objects[i].pixels.visible(), exact.objects[i].pixels.visible());
    EXPECT_EQ(found.objects[i].visibility(), exact.objects[i].visibility());
  }
  EXPECT_EQ(cv::countNonZero(found.objects[0].visible_mask().whole() &
                             found.objects[1].visible_mask().whole()),
            0);
  ASSERT_EQ(agreement_.size(), 2U);
  for (const auto& each : agreement_) EXPECT_GT(each, 0.9);
}

TEST_F(PixelLabels, SubtractionFindsEachObjectAsIfItWasAlone) {
  const Pose away = test::poseAt(0, 50, 0);
  const Pose X_GA = test::poseAt(0, kAxis + 0.3, 0.5);
  Requirements masks;
  masks.silhouettes = true;
  const auto silhouettesOf = [&](const Pose& X_GB, const Pose& X_GA_here) {
    place(X_GA_here, X_GB, {{"masks", methodOf("mog2")}});
    const Scene scene = sceneWith(masks);
    return std::vector<cv::Mat>{scene.objects[0].silhouette().whole(),
                                scene.objects[1].silhouette().whole()};
  };
  for (const double y : {-0.6, 0.1, 0.3}) {  // apart, overlapping, hidden
    const Pose X_GB = test::poseAt(1, kAxis + y, 0.5);
    const std::vector<cv::Mat> together = silhouettesOf(X_GB, X_GA);
    EXPECT_GT(cv::countNonZero(together[1]), 100);
    EXPECT_EQ(cv::norm(together[0], silhouettesOf(away, X_GA)[0], cv::NORM_INF), 0.0) << y;
    EXPECT_EQ(cv::norm(together[1], silhouettesOf(X_GB, away)[1], cv::NORM_INF), 0.0) << y;
  }
}

TEST_F(PixelLabels, SubtractionShowsNothingOfWhatNoPixelsCentreSees) {
  // Cleaning leaves a single pixel only in a picture of one row.
  run_.folder().write("camera.yaml", R"(
image_width: 7
image_height: 1
camera_matrix: {rows: 3, cols: 3, data: [6, 0, 3, 0, 6, 0, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}
)");
  int hidden = 0;
  for (int i = 0; i < 20; ++i) {
    place(test::poseAt(0, 5, 0), test::poseAt(0, kAxis + 0.02 * i, 0.5 + 0.01 * i),
          {{"masks", methodOf("mog2")}});
    const SceneObject bravo = sceneWith(everything()).objects[1];
    if (bravo.pixels.visible() > 0) continue;
    ++hidden;
    EXPECT_FALSE(bravo.visibleBox()) << i;
    EXPECT_TRUE(bravo.visible_mask().empty()) << i;
  }
  EXPECT_GE(hidden, 5);
}

TEST_F(PixelLabels, ThresholdsDropWhatIsHardlyVisible) {
  place(test::poseAt(0, kAxis, 0.1), test::poseAt(1.0, kAxis - 0.27, 0),
        {{"labels", Value(Value::Map{{"min_visibility", Value(0.75)}})}});
  // Only the threshold needs visibility.
  const Scene scene = sceneWith({});
  EXPECT_FALSE(scene.objects[0].dropped);
  EXPECT_TRUE(scene.objects[1].dropped);
  EXPECT_FALSE(scene.objects[1].labelled());
}

TEST_F(PixelLabels, WhatNobodyAsksForIsNotComputed) {
  place(test::poseAt(0, kAxis, 0.1), test::poseAt(1.0, kAxis - 0.27, 0));
  const Scene scene = sceneWith({});
  for (const auto* image :
       {&scene.instance_map, &scene.class_map, &scene.depth, &scene.normals, &scene.optical_flow}) {
    EXPECT_FALSE(image->isKnown());
  }
  const SceneObject& alpha = scene.objects[0];
  EXPECT_FALSE(alpha.silhouette.isKnown() || alpha.visible_mask.isKnown());
  EXPECT_FALSE(alpha.pixels.visible.isKnown() || alpha.pixels.silhouette.isKnown());
}

TEST_F(PixelLabels, DepthIsThatOfTheFrontFace) {
  place(test::poseAt(0, kAxis, 0), test::poseAt(0, 5, 0));
  const Scene scene = sceneWith(everything());
  const int v = 59 + 20;  // on the front face, which spans 0.1 m to 0.5 m below the axis
  EXPECT_NEAR(scene.depth().at<float>(v, 79), 2.8F, 1e-4F);
  const cv::Vec3f normal = scene.normals().at<cv::Vec3f>(v, 79);
  EXPECT_NEAR(normal[2], -1.0F, 1e-4F);
}

TEST_F(PixelLabels, OpticalFlowFollowsTheObject) {
  place(test::poseAt(0, kAxis, 0), test::poseAt(0, 5, 0));
  Requirements flow;
  flow.optical_flow = true;
  (void)sceneWith(flow);
  // In a quarter of a second alpha goes a quarter of the way to y = 5 m.
  moveTo(1);
  scene::CameraPoses next = posesAt(1);
  maker_->addOpticalFlow(*seen_, &next);
  const cv::Mat& pixels = seen_->scene.optical_flow();
  const double moved = 0.25 * (5.0 - kAxis);
  const cv::Vec2f on_front_face = pixels.at<cv::Vec2f>(79, 79);
  EXPECT_NEAR(on_front_face[0], -moved / 2.8 * 140.0, 0.05);
  EXPECT_NEAR(on_front_face[1], 0.0, 0.01);
  const cv::Vec2f on_the_floor = pixels.at<cv::Vec2f>(110, 10);
  EXPECT_NEAR(on_the_floor[0], 0.0, 1e-3);
}

TEST_F(PixelLabels, AfterTheLastSceneTheFlowIsUnknown) {
  place(test::poseAt(0, kAxis, 0), test::poseAt(0, 5, 0));
  Requirements flow;
  flow.optical_flow = true;
  (void)sceneWith(flow);
  maker_->addOpticalFlow(*seen_, nullptr);
  EXPECT_TRUE(std::isnan(seen_->scene.optical_flow().at<cv::Vec2f>(79, 79)[0]));
}

}  // namespace pixel_labels_test
}  // namespace synthetic_dataset::label

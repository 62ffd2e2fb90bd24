#include "run/scene_loop.h"

#include <gmock/gmock.h>

#include "support/box_world.h"
#include "support/error_messages.h"
#include "support/fake_frame_source.h"
#include "support/fake_scene_sink.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::run {
namespace scene_loop_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr int kInstants = 4;  // per motion

/// The optical frame of a camera at the origin that looks along the global x.
Pose lookingAlongX() {
  Pose X_GC = Pose::Identity();
  X_GC.matrix().topLeftCorner<3, 3>() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return X_GC;
}

/// Scenes of a box of 1 m whose front is 5 m ahead of the camera; no bag, no world file, no writer.
class SceneLoopTest : public testing::Test {
 protected:
  SceneLoopTest() {
    addMotion();
    setup.splits =
        std::make_unique<SplitPlan>(config::SplitConfig{}, 0, std::vector<SplitPart>{{kInstants}});
  }

  void addMotion() {
    scene::ObjectOptions box;
    box.name = box.frame = "box";
    box.bounding_shape_O = test::boxCorners({1.0, 1.0, 1.0});
    setup.config.objects = {box};
    MotionSetup& motion = setup.motions.emplace_back();
    motion.config = setup.config;
    motion.first_instant = kInstants * (static_cast<std::int64_t>(setup.motions.size()) - 1);
    for (int i = 1; i <= kInstants; ++i) {
      motion.timeline.stamps.push_back(std::chrono::milliseconds(100 * i));
    }
    Pose X_GO = Pose::Identity();
    X_GO.translation().x() = 5.5;
    motion.frames = std::make_unique<motion::PlacedFrames>(std::make_shared<test::FakeFrameSource>(
        std::map<std::string, test::FakeFrameSource::PoseAt>{
            {"box", test::FakeFrameSource::fixed(X_GO)}}));
    motion.variants.emplace_back(box, randomize::Randomization{});
    motion.world = makeWorld();
    motion.cameras.push_back({"camera",
                              CameraModel(160, 120, {100.0, 100.0, 79.5, 59.5}, 0.05, 100.0),
                              "optical", lookingAlongX()});
    motion.driven_links = {{{}}};
    motion.shapes = std::make_unique<scene::ObjectShapes>(motion.config.objects, motion.variants,
                                                          *motion.world);
    motion.arranger = std::make_unique<scene::SceneArranger>(
        motion.config, motion.cameras, motion.variants, *motion.shapes, *motion.world,
        *motion.frames, motion.diagnostics);
    motion.variation = std::make_unique<scene::SceneVariation>(
        motion.config, motion.cameras, motion.variants, *motion.world, motion.diagnostics);
  }

  [[nodiscard]] static std::unique_ptr<world::World> makeWorld() {
    world::Visual visual;
    visual.surfaces.push_back({test::boxMesh({1.0, 1.0, 1.0}), {}});
    world::Link link;
    link.name = "body";
    link.visuals = {visual};
    world::Model model;
    model.name = "box";
    model.links = {link};
    return std::make_unique<world::World>(
        world::Description{}, std::vector<world::MovingObject>{model}, world::PhysicsOptions{});
  }

  SceneLoop::Result runLoop() { return SceneLoop(setup, sink, reporter).run(); }

  [[nodiscard]] std::vector<std::int64_t> indicesInSink() const {
    std::vector<std::int64_t> indices;
    for (const FinishedScene& each : sink.scenes) indices.push_back(each.scene.index);
    return indices;
  }

  /// Stops once `stop_after` scenes are done.
  struct StoppingReporter : Reporter {
    void progress(std::int64_t done, std::int64_t /*all*/) override { scenes = done; }
    [[nodiscard]] bool stopRequested() const override { return scenes >= stop_after; }

    std::int64_t scenes = 0;
    std::int64_t stop_after = 1000;
  };

  RunSetup setup;
  test::FakeSceneSink sink;
  StoppingReporter reporter;
};

TEST_F(SceneLoopTest, LabelsWhatTheCameraSees) {
  sink.required.visible_masks = true;
  EXPECT_EQ(runLoop().scenes, kInstants);
  ASSERT_THAT(sink.scenes, SizeIs(kInstants));
  const Scene& scene = sink.scenes.front().scene;
  // Half a metre at 5 m is 10 pixels: the front covers those from 70 to 89 and from 50 to 69.
  ASSERT_THAT(scene.objects, SizeIs(1));
  EXPECT_EQ(scene.objects.front().pixels.visible(), 20 * 20);
  EXPECT_EQ(scene.instance_map().at<std::uint16_t>(50, 70), 1);
  EXPECT_EQ(scene.instance_map().at<std::uint16_t>(49, 70), 0);
  EXPECT_EQ(scene.instance_map().at<std::uint16_t>(69, 89), 1);
  EXPECT_EQ(scene.instance_map().at<std::uint16_t>(69, 90), 0);
  EXPECT_NE(scene.image.at<cv::Vec3b>(60, 80), scene.image.at<cv::Vec3b>(10, 10));
}

TEST_F(SceneLoopTest, ComputesNothingThatTheSinkDoesNotRequire) {
  runLoop();
  const Scene& scene = sink.scenes.front().scene;
  EXPECT_FALSE(scene.image.empty());
  EXPECT_FALSE(scene.instance_map.isKnown());
  EXPECT_FALSE(scene.depth.isKnown());
}

TEST_F(SceneLoopTest, LetsTheSinkBeginAddAndFinish) {
  SceneLoop loop(setup, sink, reporter);
  ASSERT_TRUE(sink.dataset);
  EXPECT_EQ(sink.dataset->scene_count, kInstants);
  EXPECT_EQ(sink.dataset->cameras.front().frame, "optical");
  EXPECT_THAT(sink.scenes, IsEmpty());
  loop.run();
  EXPECT_THAT(indicesInSink(), ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(sink.end, RunEnd::kAllMade);
}

TEST_F(SceneLoopTest, MakesTheScenesThatTheSinkWants) {
  sink.is_wanted = [](std::int64_t scene) { return scene == 1 || scene == 2; };
  SceneLoop loop(setup, sink, reporter);
  EXPECT_EQ(loop.sceneCount(), 2);
  EXPECT_EQ(loop.run().scenes, 2);
  EXPECT_THAT(indicesInSink(), ElementsAre(1, 2));
}

TEST_F(SceneLoopTest, PassesASceneOnOnlyWhenItsOpticalFlowIsKnown) {
  sink.required.optical_flow = true;
  sink.is_wanted = [](std::int64_t scene) { return scene < 2; };
  runLoop();
  ASSERT_THAT(indicesInSink(), ElementsAre(0, 1));
  for (const FinishedScene& each : sink.scenes) {
    EXPECT_EQ(each.scene.optical_flow().at<cv::Vec2f>(60, 80), cv::Vec2f(0.0F, 0.0F))
        << "nothing moves, and a scene that is not wanted tells so for the last one";
  }
}

TEST_F(SceneLoopTest, GoesOnToTheNextMotion) {
  addMotion();
  setup.splits = std::make_unique<SplitPlan>(config::SplitConfig{}, 0,
                                             std::vector<SplitPart>{{kInstants}, {kInstants}});
  sink.is_wanted = [](std::int64_t scene) { return scene >= 3; };
  runLoop();
  EXPECT_THAT(indicesInSink(), ElementsAre(3, 4, 5, 6, 7));
}

TEST_F(SceneLoopTest, LetsTheSinkFinishWhenItIsStopped) {
  reporter.stop_after = 1;
  const SceneLoop::Result result = runLoop();
  EXPECT_EQ(result.end, RunEnd::kStopped);
  EXPECT_EQ(sink.end, RunEnd::kStopped);
  EXPECT_GE(result.scenes, 1);
  EXPECT_EQ(result.scenes, static_cast<std::int64_t>(sink.scenes.size()));
}

TEST_F(SceneLoopTest, EndsWithTheErrorOfTheSink) {
  sink.on_add = [](const FinishedScene&) { throw Error("the disk is full"); };
  EXPECT_THAT(test::messagesOf([&] { runLoop(); }),
              testing::ElementsAre(HasSubstr("the disk is full")));
  EXPECT_FALSE(sink.end);
}

}  // namespace scene_loop_test
}  // namespace synthetic_dataset::run

#include "run/live/live_run.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "base/input_file.h"
#include "base/json_text.h"
#include "run/generator.h"
#include "run/live/one_scene_sink.h"
#include "run/scene_loop.h"
#include "run/setup/run_setup.h"
#include "support/error_messages.h"
#include "support/tiny_run.h"
#include "support/writers/plugin_environment.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::run {
namespace live_run_test {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

class LiveRunTest : public testing::Test {
 protected:
  LiveRunTest() { test::preparePluginEnvironment(); }

  /// The scene as made by a fresh run, which knows nothing of earlier scenes.
  [[nodiscard]] static Scene freshScene(const Value::Map& settings, std::int64_t index) {
    RunSetup setup = setUpRun(Value(settings), {test::pluginXml()});
    OneSceneSink sink(index);
    Reporter silent;
    SceneLoop(setup, sink, silent).run();
    return sink.scene().value();
  }

  [[nodiscard]] static Value uniform(double low, double high) {
    return Value::Map{{"uniform", Value::List{Value(low), Value(high)}}};
  }

  /// The world without its ball.
  void writeBareWorld() const {
    std::string world = base::readInput(tiny.folder() / "tiny.world");
    const std::size_t begin = world.find("<model name=\"ball\">");
    const std::string end = "</model>";
    world.erase(begin, world.find(end, begin) + end.size() - begin);
    tiny.folder().write("bare.world", world);
  }

  static void expectSame(const Scene& scene, const Scene& fresh) {
    EXPECT_EQ(scene.name, fresh.name);
    EXPECT_EQ(scene.stamp, fresh.stamp);
    EXPECT_TRUE(scene.X_GC.isApprox(fresh.X_GC, 0.0));
    EXPECT_EQ(cv::norm(scene.image, fresh.image, cv::NORM_INF), 0.0);
    EXPECT_EQ(cv::norm(scene.depth(), fresh.depth(), cv::NORM_INF), 0.0);
    EXPECT_EQ(cv::norm(scene.instance_map(), fresh.instance_map(), cv::NORM_INF), 0.0);
    ASSERT_THAT(scene.objects, SizeIs(fresh.objects.size()));
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      EXPECT_EQ(scene.objects[i].name, fresh.objects[i].name);
      EXPECT_EQ(scene.objects[i].pixels.silhouette(), fresh.objects[i].pixels.silhouette());
    }
  }

  test::TinyRun tiny;
  Value::Map settings = tiny.parameters();
  LiveRun live{{test::pluginXml()}};
};

TEST_F(LiveRunTest, ShowsTheScenesThatTheRunMakes) {
  live.setSettings(settings);
  expectSame(live.scene(2).scene, freshScene(settings, 2));
}

TEST_F(LiveRunTest, GlancesAtTheSameScenesCoarsely) {
  live.setSettings(settings);
  for (const std::int64_t instant : {2, 0, 2}) {
    const Scene whole = live.scene(instant).scene;
    const cv::Mat coarse = live.glance(instant, "", whole.X_GC);
    ASSERT_EQ(coarse.size(), whole.image.size() / 2);
    cv::Mat shrunk;
    cv::resize(whole.image, shrunk, coarse.size(), 0.0, 0.0, cv::INTER_AREA);
    cv::Mat difference;
    cv::absdiff(coarse, shrunk, difference);
    // Only one of them has sharp edges; elsewhere they are alike.
    EXPECT_LT(cv::mean(difference)[0], 6.0) << instant;
  }
}

TEST_F(LiveRunTest, GlancesFromWhereTheCameraIsMoved) {
  Value::Map aside = settings;
  (*aside["camera"].as<Value::Map>())["pose"] = Value::Map{
      {"position", Value::List{Value(-2.0), Value(1.5), Value(1.0)}}, {"look_at", Value("bravo")}};
  live.setSettings(aside);
  const Scene there = live.scene(1).scene;
  live.setSettings(settings);
  const Scene here = live.scene(1).scene;
  const cv::Mat first = live.glance(1, "", here.X_GC);
  const cv::Mat moved = live.glance(1, "", there.X_GC);
  const cv::Mat back = live.glance(1, "", here.X_GC);
  EXPECT_EQ(cv::norm(first, back, cv::NORM_INF), 0.0);
  cv::Mat shrunk;
  cv::resize(there.image, shrunk, moved.size(), 0.0, 0.0, cv::INTER_AREA);
  EXPECT_LT(cv::norm(moved, shrunk, cv::NORM_L1), cv::norm(first, shrunk, cv::NORM_L1));
  EXPECT_THROW((void)live.glance(99, "", here.X_GC), Error);
  // A glance does not change the run's own scenes.
  expectSame(live.scene(1).scene, freshScene(settings, 1));
}

/// One setting after another is changed and changed back.
TEST_F(LiveRunTest, ShowsWhatAFreshRunMakesAfterAnyChanges) {
  const auto file = [&](const char* name) { return Value((tiny.folder() / name).string()); };
  const Value::Map first = settings;
  Value::Map aside = first;  // another pose
  (*aside["camera"].as<Value::Map>())["pose"] = Value::Map{
      {"position", Value::List{Value(-2.0), Value(1.5), Value(1.0)}}, {"look_at", Value("bravo")}};
  Value::Map shorter = first;  // another time
  shorter["duration"] = Value(0.6);
  Value::Map alone = first;  // another list of robots
  alone["robot_list"] = Value::List{Value("bravo")};
  Value::Map elsewhere = first;  // another world: the same without its ball
  elsewhere["world"] = file("bare.world");
  writeBareWorld();
  Value::Map painted = first;
  painted["randomize"] =
      Value::Map{{"lights", Value::Map{{"every", Value::Map{{"intensity", uniform(0.4, 1.2)}}}}},
                 {"objects", Value::Map{{"alpha", Value::Map{{"scale", uniform(0.7, 1.3)}}}}}};
  const std::vector<Value::Map> all = {first, aside,     first,   painted, aside,
                                       alone, elsewhere, painted, shorter, first};
  std::int64_t index = 0;
  for (const Value::Map& each : all) {
    SCOPED_TRACE(base::jsonText(Value(each)));
    live.setSettings(each);
    ASSERT_THAT(live.setup().problems,
                Not(Contains(Field(&LiveProblem::severity, base::Severity::kError))));
    index = (index + 3) % static_cast<std::int64_t>(live.setup().stamps.size());
    expectSame(live.scene(index).scene, freshScene(each, index));
  }
}

/// The ball falls and is pushed meanwhile: where it lies depends on all that happened before.
TEST_F(LiveRunTest, JumpsToAndFroInARecording) {
  live.setSettings(settings);
  for (const std::int64_t instant : {3, 1, 2, 3, 0}) {
    expectSame(live.scene(instant).scene, freshScene(settings, instant));
  }
  (*settings["camera"].as<Value::Map>())["pose"] =
      Value::Map{{"position", Value::List{Value(-2.0), Value(-1.0), Value(0.8)}},
                 {"look_at", Value::List{Value(0.3), Value(-0.8), Value(0.1)}}};
  live.setSettings(settings);
  expectSame(live.scene(3).scene, freshScene(settings, 3));
  settings["physics"] = Value::Map{{"step", Value(0.002)}};
  live.setSettings(settings);
  expectSame(live.scene(3).scene, freshScene(settings, 3));
}

TEST_F(LiveRunTest, SeesFilesThatHaveChanged) {
  live.setSettings(settings);
  const Scene before = live.scene(1).scene;
  std::string world = base::readInput(tiny.folder() / "tiny.world");
  const std::string red = "0.9 0.2 0.1";
  for (std::size_t at = world.find(red); at != std::string::npos; at = world.find(red)) {
    world.replace(at, red.size(), "0.2 0.9 0.1");
  }
  tiny.folder().write("tiny.world", world);
  const Scene after = live.scene(1).scene;
  EXPECT_GT(cv::norm(before.image, after.image, cv::NORM_INF), 0.0);
  expectSame(after, freshScene(settings, 1));
}

TEST_F(LiveRunTest, SaysWhatTheSettingsAmountTo) {
  live.setSettings(settings);
  const LiveSetup& setup = live.setup();
  EXPECT_TRUE(setup.ready);
  EXPECT_THAT(setup.stamps, SizeIs(4));
  EXPECT_THAT(setup.cameras, ElementsAre("camera"));
  EXPECT_THAT(setup.objects, ElementsAre("alpha", "bravo"));
}

TEST_F(LiveRunTest, KnowsTheDatasetThatTheRunWouldWriteTo) {
  live.setSettings(settings);
  EXPECT_FALSE(live.setup().earlier);
  Reporter silent;
  (void)Generator(Value(settings), silent, {test::pluginXml()}).run();
  ASSERT_TRUE(live.setup().earlier) << "without a change of the settings";
  EXPECT_TRUE(live.setup().earlier->complete);
  EXPECT_THAT(live.setup().earlier->differences, IsEmpty());
  EXPECT_THAT(live.setup().problems, IsEmpty());
  settings["simulated_rate"] = Value(2.0);
  live.setSettings(settings);
  const auto is_in_the_way =
      AllOf(Field(&LiveProblem::path, ElementsAre("output_folder")),
            Field(&LiveProblem::found, HasSubstr("a complete dataset of 4 scenes of other")));
  EXPECT_THAT(live.setup().problems, ElementsAre(is_in_the_way));
  EXPECT_TRUE(live.setup().ready);
  const std::vector<LiveProblem> checked = live.check().problems;
  EXPECT_EQ(1, std::count_if(checked.begin(), checked.end(), [&](const LiveProblem& each) {
              return testing::Value(each, is_in_the_way);
            }));
}

TEST_F(LiveRunTest, NamesTheSettingsThatAreWrong) {
  settings["simulated_rate"] = Value(-1.0);
  (*settings["alpha"].as<Value::Map>())["keypoints"] = Value("none");
  live.setSettings(settings);
  const LiveSetup& setup = live.setup();
  EXPECT_FALSE(setup.ready);
  EXPECT_THAT(setup.problems, Contains(Field(&LiveProblem::path, ElementsAre("simulated_rate"))));
  EXPECT_THAT(setup.problems,
              Contains(Field(&LiveProblem::path, ElementsAre("alpha", "keypoints"))));
  EXPECT_THAT(test::messagesOf([&] { (void)live.scene(0); }),
              Contains(HasSubstr("simulated_rate")));
}

TEST_F(LiveRunTest, GoesOnWhenTheSettingsAreMended) {
  live.setSettings(Value::Map{});
  EXPECT_FALSE(live.setup().ready);
  live.setSettings(settings);
  EXPECT_TRUE(live.setup().ready);
  EXPECT_FALSE(live.scene(0).scene.image.empty());
}

TEST_F(LiveRunTest, KnowsNoInstantAfterTheLast) {
  live.setSettings(settings);
  EXPECT_THAT(test::messagesOf([&] { (void)live.scene(4); }), ElementsAre(HasSubstr("0 to 3")));
  EXPECT_THAT(test::messagesOf([&] { (void)live.scene(0, "camara"); }),
              ElementsAre(HasSubstr("did you mean 'camera'")));
}

TEST_F(LiveRunTest, GivesLabelsForPrograms) {
  live.setSettings(settings);
  const Value::Map value = sceneValue(live.scene(0));
  const Value::Map& labels = *value.at("labels").as<Value::Map>();
  const Value::List& objects = *labels.at("objects").as<Value::List>();
  ASSERT_THAT(objects, SizeIs(2));
  const Value::Map& alpha = *objects.front().as<Value::Map>();
  EXPECT_EQ(alpha.at("name"), Value("alpha"));
  EXPECT_THAT(*alpha.at("cuboid").as<Value::List>(), SizeIs(8));
  EXPECT_THAT(*alpha.at("box").as<Value::List>(), SizeIs(4));
  EXPECT_THAT(*alpha.at("polygons").as<Value::List>(), SizeIs(1));
}

TEST_F(LiveRunTest, ShowsTheRecordingWhateverElseIsWrong) {
  settings.erase("world");
  settings.erase("camera");
  live.setSettings(settings);
  const Value::Map value = recordingValue(live.recording());
  const Value::List& frames = *value.at("frames").as<Value::List>();
  ASSERT_THAT(frames, SizeIs(2));
  EXPECT_EQ(value.at("duration"), Value(1.0));
  const auto* alpha = frames.front().as<Value::Map>();
  if (alpha->at("name") != Value("alpha/base_link")) alpha = frames.back().as<Value::Map>();
  EXPECT_EQ(alpha->at("name"), Value("alpha/base_link"));
  EXPECT_EQ(alpha->at("looks_like_robot"), Value(true));
  EXPECT_NEAR(*alpha->at("moved").as<double>(), 1.0, 1e-9);
  EXPECT_NEAR(*alpha->at("turned").as<double>(), 0.0, 1e-6);
  EXPECT_NEAR(*alpha->at("rate").as<double>(), 20.0, 1e-6);
  EXPECT_EQ(base::jsonText(alpha->at("known")), "[[0.0, 1.0]]");
  const Value::Map& ways = *value.at("ways").as<Value::Map>();
  ASSERT_EQ(ways.size(), 1U);
  const Value::List& way = *ways.at("alpha/base_link").as<Value::List>();
  EXPECT_EQ(base::jsonText(way.front()), "[0.0, -0.5]");
  EXPECT_EQ(base::jsonText(way.back()), "[0.0, 0.5]");
}

TEST_F(LiveRunTest, ShowsTheWorldWithoutWhatIsMissing) {
  std::string world = base::readInput(tiny.folder() / "tiny.world");
  const std::string end = "</world>";
  world.insert(world.find(end),
               "<model name='lost'><link name='l'><visual name='v'><geometry><mesh>"
               "<uri>lost.dae</uri></mesh></geometry></visual></link></model>");
  tiny.folder().write("tiny.world", world);
  live.setSettings(settings);
  const LiveWorld shown = live.world();
  EXPECT_THAT(shown.missing, Contains(HasSubstr("lost.dae")));
  EXPECT_THAT(shown.description.models, SizeIs(5));
  // The floor's 8 m by 8 m, on which only the ball stands: it is shown with the objects' places.
  EXPECT_FALSE(shown.map.picture.empty());
  EXPECT_TRUE(shown.map.extent.contains(Eigen::Vector2d(0.3, -0.8)));
  EXPECT_FALSE(live.setup().ready);
}

TEST_F(LiveRunTest, PicksPointsOnAModelWhereItsPortraitIsClicked) {
  settings.erase("camera");  // only the object has to be right
  live.setSettings(settings);
  ASSERT_FALSE(live.setup().ready);
  Viewpoint front;
  front.yaw = 0.0;
  front.pitch = 0.0;
  const ObjectPortrait portrait = live.portrait("alpha", front);
  EXPECT_EQ(portrait.picture.cols, front.width);
  EXPECT_NEAR(portrait.box_O.high.z(), 0.4, 1e-6);
  const Eigen::Vector2d middle(0.5 * (portrait.picture.cols - 1),
                               0.5 * (portrait.picture.rows - 1));
  const auto picked = live.pick("alpha", front, middle);
  ASSERT_TRUE(picked);
  EXPECT_EQ(picked->link, "body");
  EXPECT_TRUE(picked->p_O.isApprox(Eigen::Vector3d(0.2, 0.0, 0.2), 1e-6))
      << picked->p_O.transpose();
  EXPECT_FALSE(live.pick("alpha", front, {0.0, 0.0})) << "the ground is not of the object";
  // The keypoints are in the middle of the upper front and back edges.
  ASSERT_THAT(portrait.keypoints, SizeIs(2));
  EXPECT_TRUE(portrait.keypoints.front().is_visible);
  EXPECT_FALSE(portrait.keypoints.back().is_visible);
}

TEST_F(LiveRunTest, LooksAtModelsFromWhereOneStands) {
  live.setSettings(settings);
  Viewpoint above;
  above.pitch = 1.5;
  const ObjectPortrait portrait = live.portrait("alpha", above);
  const Eigen::Vector2d middle(0.5 * (portrait.picture.cols - 1),
                               0.5 * (portrait.picture.rows - 1));
  const auto picked = live.pick("alpha", above, middle);
  ASSERT_TRUE(picked);
  EXPECT_NEAR(picked->p_O.z(), 0.4, 1e-6) << "its roof";
  EXPECT_THAT(test::messagesOf([&] { (void)live.portrait("alpho", above); }),
              ElementsAre(HasSubstr("did you mean 'alpha'")));
}

TEST_F(LiveRunTest, DrawsTheRandomisationAnewWithOtherSeeds) {
  settings["randomize"] =
      Value::Map{{"lights", Value::Map{{"every", Value::Map{{"intensity", uniform(0.4, 1.2)}}}}}};
  live.setSettings(settings);
  const std::vector<LiveDraw> draws = live.draws(3, 1);
  ASSERT_THAT(draws, SizeIs(3));
  EXPECT_EQ(cv::norm(draws[0].picture, live.scene(1).scene.image, cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(draws[0].picture, draws[1].picture, cv::NORM_INF), 0.0);
  EXPECT_NE(drawsValue(draws[1]), drawsValue(draws[2]));
}

TEST_F(LiveRunTest, AddsWhatACheckFinds) {
  live.setSettings(settings);
  EXPECT_FALSE(live.setup().figures);
  const LiveSetup& checked = live.check();
  ASSERT_TRUE(checked.figures);
  EXPECT_GT(checked.figures->bytes, 0);
  EXPECT_TRUE(live.setup().figures) << "as long as the settings are the same";
  live.setSettings(settings);
  EXPECT_FALSE(live.setup().figures);
}

TEST_F(LiveRunTest, ShowsWhereAMapIsFree) {
  const std::vector<randomize::Cell> cells = {randomize::Cell::kFree, randomize::Cell::kOccupied,
                                              randomize::Cell::kUnknown, randomize::Cell::kFree};
  const LiveMap map = pictureOf(randomize::OccupancyMap(2, 2, 0.5, {1.0, 2.0, 0.0, 0.0}, cells));
  EXPECT_EQ(base::jsonText(extentValue(map.extent)), "[1.0, 2.0, 2.0, 3.0]");
  const cv::Mat& picture = map.picture;
  const auto grey = [&](int row, int column) { return picture.at<cv::Vec3b>(row, column)[0]; };
  const int last = picture.rows - 1;
  EXPECT_GT(grey(last, 0), 240) << "the lower left cell is free";
  EXPECT_LT(grey(last, picture.cols - 1), 100);
  EXPECT_GT(grey(0, picture.cols - 1), 240);
  EXPECT_LT(grey(0, 0), 240);
}

TEST(LiveProblem, IsSplitIntoWhatWasFoundAndWhatWouldBeRight) {
  const LiveProblem problem =
      problemOf(base::Severity::kError, "motions/0/bag_file: found 'x'; it should be a bag");
  EXPECT_THAT(problem.path, ElementsAre("motions", "0", "bag_file"));
  EXPECT_EQ(problem.found, "found 'x'");
  EXPECT_EQ(problem.cure, "it should be a bag");
  EXPECT_THAT(problemOf(base::Severity::kError, "/a/b.world: line 3: odd").path, IsEmpty());
  EXPECT_THAT(problemOf(base::Severity::kError, "no sun").path, IsEmpty());
}

}  // namespace live_run_test
}  // namespace synthetic_dataset::run

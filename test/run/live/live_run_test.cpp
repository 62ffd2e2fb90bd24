#include "run/live/live_run.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include "base/input_file.h"
#include "base/json_text.h"
#include "run/live/one_scene_sink.h"
#include "run/scene_loop.h"
#include "run/setup/run_setup.h"
#include "support/error_messages.h"
#include "support/tiny_run.h"
#include "support/writers/plugin_environment.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::run {
namespace live_run_test {

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

  /// The scene as a run makes it that knows nothing of those before.
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

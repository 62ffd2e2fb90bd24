/// Runs whose scenes are made at random offsets from their regular times.

#include <cmath>
#include <filesystem>
#include <set>

#include <gmock/gmock.h>

#include "all_at_once_run.h"
#include "base/sqlite.h"
#include "base/yaml_value.h"
#include "run/merger.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::run {
namespace time_jitter_test {

namespace fs = std::filesystem;
using test::AllAtOnceRun;
using test::StoppingReporter;
using ::testing::AllOf;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Ge;
using ::testing::HasSubstr;
using ::testing::IsSubsetOf;
using ::testing::SizeIs;

constexpr std::int64_t kStart = 1000000000;   // of the recording [ns]
constexpr std::int64_t kPeriod = 125000000;   // [ns]
constexpr std::int64_t kFarthest = 40000000;  // [ns]

Value yaml(const std::string& text) { return base::parseYaml(text, "test"); }

/// A scene as listed in the manifest.
struct ListedScene {
  std::int64_t stamp = 0;   ///< [ns]
  std::int64_t jitter = 0;  ///< that was drawn [ns]
  double alpha_y = 0.0;     ///< [m]

  [[nodiscard]] std::int64_t regular() const { return stamp - jitter; }
};

/// Two cameras; alpha goes along y at 1 m/s, from -0.5 m on.
class TimeJitter : public ::testing::Test {
 protected:
  TimeJitter() { jitter("{uniform: [-0.04, 0.04]}"); }

  void jitter(const std::string& text) {
    run.parameters["randomize"] = yaml("{time: {jitter: " + text + "}}");
  }

  void setEffects(const std::string& text) {
    Value::Map cameras = *run.parameters.at("cameras").as<Value::Map>();
    for (auto& [name, camera] : cameras) (*camera.as<Value::Map>())["effects"] = yaml(text);
    run.parameters["cameras"] = Value(cameras);
  }

  /// The left camera's scenes.
  std::vector<ListedScene> generate() {
    fs::remove_all(run.folder());
    (void)run.run();
    const base::SqliteDatabase manifest(run.folder() + "/manifest.sqlite",
                                        base::SqliteDatabase::Mode::kReadOnly);
    base::SqliteStatement row(manifest,
                              "SELECT stamp_ns, value, alpha_y FROM scene JOIN draw ON "
                              "draw.scene = scene.\"index\" AND name = "
                              "'time/jitter' JOIN (SELECT scene AS of, y AS alpha_y FROM "
                              "scene_object WHERE object = 0) ON of = "
                              "scene.\"index\" WHERE camera = 'left' ORDER BY scene.\"index\"");
    std::vector<ListedScene> scenes;
    while (row.step()) {
      const double seconds = *yaml(row.text(1)).as<double>();
      scenes.push_back({row.integer(0), std::llround(seconds * 1e9), row.real(2)});
    }
    return scenes;
  }

  [[nodiscard]] static std::vector<std::int64_t> stampsOf(const std::vector<ListedScene>& scenes) {
    std::vector<std::int64_t> stamps;
    for (const ListedScene& scene : scenes) stamps.push_back(scene.stamp);
    return stamps;
  }

  AllAtOnceRun run;
};

TEST_F(TimeJitter, MovesEachSceneByWhatTheManifestTells) {
  const std::vector<ListedScene> scenes = generate();
  ASSERT_THAT(scenes, SizeIs(Ge(7U)));
  std::set<std::int64_t> drawn;
  for (const ListedScene& scene : scenes) {
    EXPECT_LE(std::abs(scene.jitter), kFarthest);
    EXPECT_EQ((scene.regular() - kStart) % kPeriod, 0) << scene.regular();
    EXPECT_NEAR(scene.alpha_y, -0.5 + static_cast<double>(scene.stamp - kStart) * 1e-9, 1e-6)
        << "objects are where they are then";
    drawn.insert(scene.jitter);
  }
  EXPECT_EQ(drawn.size(), scenes.size());
  EXPECT_LT(*drawn.begin(), 0);
  EXPECT_GT(*drawn.rbegin(), 0);
}

TEST_F(TimeJitter, OfASceneDoesNotDependOnWhichOthersThereAre) {
  const std::vector<ListedScene> all = generate();
  // All has to be known while the shutter is open: there are no scenes at the recording's ends.
  setEffects("{exposure_time: 0.04, motion_samples: 2}");
  const std::vector<ListedScene> fewer = generate();
  EXPECT_LT(fewer.size(), all.size());
  EXPECT_THAT(stampsOf(fewer), IsSubsetOf(stampsOf(all)));
  for (const ListedScene& scene : fewer) EXPECT_EQ((scene.regular() - kStart) % kPeriod, 0);
}

TEST_F(TimeJitter, FollowsFromTheSeed) {
  const auto stamps = stampsOf(generate());
  EXPECT_EQ(stampsOf(generate()), stamps);
  run.parameters["seed"] = Value(8);
  EXPECT_NE(stampsOf(generate()), stamps);
}

TEST_F(TimeJitter, GivesTheSameBytesResumedInShardsAndAlone) {
  run.parameters["randomize"] =
      yaml("{time: {jitter: {uniform: [0, 0.1]}}, sensor: {exposure: {uniform: [-1, 1]}}}");
  (void)run.run();
  const auto expected = AllAtOnceRun::files(run.folder());
  const auto expectFiles = [&] {
    EXPECT_TRUE(AllAtOnceRun::files(run.folder()) == expected);
    fs::remove_all(run.folder());
  };
  fs::remove_all(run.folder());
  StoppingReporter stopping(5);
  (void)run.run(stopping, run.folder());
  (void)run.run();
  expectFiles();
  for (const int index : {1, 0}) (void)run.runShard(index, 2, run.folder());
  Reporter silent;
  mergeShards(run.folder(), {}, silent, {test::pluginXml()});
  expectFiles();
  run.parameters["only_scenes"] = yaml("[5]");
  (void)run.run();
  run.parameters.erase("only_scenes");
  (void)run.run();
  expectFiles();
}

TEST_F(TimeJitter, IsAnErrorWhereScenesWouldLoseTheirOrder) {
  jitter("{uniform: [-0.07, 0.06]}");
  EXPECT_THAT(run.errors(),
              ElementsAre(AllOf(HasSubstr("randomize/time/jitter: found -0.07 to 0.06 s"),
                                HasSubstr("less than 0.125 s apart"))));
  jitter("{normal: [0, 0.01]}");
  EXPECT_THAT(run.errors(), ElementsAre(HasSubstr("needs `min` and `max`")));
  jitter("{uniform: [-0.06, 0.06]}");
  EXPECT_THAT(run.errors(), ElementsAre());
}

TEST_F(TimeJitter, LeavesTheShutterLessTime) {
  setEffects("{exposure_time: 0.06, motion_samples: 2}");
  EXPECT_THAT(run.errors(),
              Each(AllOf(HasSubstr("exposure_time"), HasSubstr("at most the 0.0450 s"),
                         HasSubstr("randomize/time/jitter"))));
  EXPECT_THAT(run.errors(), SizeIs(2)) << "one a camera";
}

TEST_F(TimeJitter, MeansNothingWithoutARecording) {
  run.parameters.erase("bag_file");
  run.parameters["motion"] = Value("placement");
  run.parameters["scenes"] = Value(2);
  run.parameters["placement"] =
      yaml("{mode: volume, volume: {min: [-0.5, -1, 0.6], max: [0.5, 0.5, 1.5]}}");
  EXPECT_THAT(run.errors(),
              ElementsAre(HasSubstr("randomize/time/jitter: has a meaning with motion: "
                                    "bag alone")));
}

}  // namespace time_jitter_test
}  // namespace synthetic_dataset::run

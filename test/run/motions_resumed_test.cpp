/// Datasets of several motions that are made in parts.

#include <filesystem>

#include <gmock/gmock.h>

#include "all_at_once_run.h"
#include "base/yaml_value.h"
#include "run/merger.h"
#include "support/bag_builder.h"
#include "support/temporary_folder.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::run {
namespace motions_resumed_test {

namespace fs = std::filesystem;
using test::AllAtOnceRun;
using test::milliseconds;
using test::poseAt;

using Files = std::map<std::string, std::string>;

Value yaml(const std::string& text) { return base::parseYaml(text, "test"); }

/// Counts a run's times and stops it after a number of them, whatever is written by then.
struct TimesReporter : Reporter {
  explicit TimesReporter(int most = 1000) : left(most) {}

  [[nodiscard]] bool stopRequested() const override {
    if (left == 0) return true;
    --left;
    ++times;
    return false;
  }

  mutable int left;
  mutable int times = 0;
};

constexpr int kEnd = 1;  // stopRequested() is called once more after the last scene

/// Three recorded times, two of another recording without bravo, two placed ones, and three of the
/// first recording in other light; each of two cameras: 20 scenes.
class PartsOfMotions : public ::testing::Test {
 protected:
  PartsOfMotions() {
    const std::string folder = fs::path(run.input("tiny.bag")).parent_path().string();
    test::BagBuilder bag(folder + "/lone.bag");
    for (int i = 0; i <= 20; ++i) {
      bag.move("map", "alpha/base_link", milliseconds(5000 + 50 * i),
               poseAt(0.3, 0.5 - 0.04 * i, 0.0));
    }
    bag.close();
    run.parameters["simulated_rate"] = Value(2.5);
    keepFewFormats();
    run.parameters["split"] = yaml("{by: scenes, train: 0.5, val: 0.5}");
    run.parameters["randomize"] = yaml(
        "{sensor: {exposure: {uniform: [-1, 1]}}, materials: {floor: {textures: procedural}}}");
    run.parameters["motions"] = yaml(
        "[{name: first}, {bag_file: " + folder +
        "/lone.bag, robot_list: [alpha], duration: 0.6, cameras: {left: {far: 50, effects: "
        "{noise_stddev: 0.02}}}}, {motion: placement, scenes: 2, split: test, placement: {mode: "
        "drop, volume: {min: [-0.5, -1, 0.6], max: [0.5, 0.5, 1.5]}}}, {name: dark, randomize: "
        "{lights: {sun: {intensity: {uniform: [0.2, 0.6]}}}, objects: {bravo: {present: 0.6}}}}]");
  }

  void keepFewFormats() {
    for (const char* type : {"Bop", "PvNet", "RosBag"}) {
      run.parameters.erase(std::string("w_") + type);
    }
    Value::List writers;
    for (const char* type : {"Coco", "ImageFolder", "UltralyticsYolo"}) {
      writers.emplace_back(Value::Map{{"name", Value(std::string("w_") + type)},
                                      {"type", Value(std::string("synthetic_dataset/") + type)}});
    }
    run.parameters["writers"] = Value(writers);
  }

  [[nodiscard]] Files atOnce() const {
    EXPECT_GT(run.unbroken().size(), 100U);
    return run.unbroken();
  }

  static constexpr std::int64_t kScenes = 20;
  AllAtOnceRun run;
};

TEST_F(PartsOfMotions, GiveTheBytesOfAllAtOnceWhenResumedWithinAnyOfThem) {
  const Files expected = atOnce();
  for (const int times : {1, 4, 6, 9}) {  // one within each motion
    fs::remove_all(run.folder());
    TimesReporter stopping(times);
    EXPECT_TRUE(run.run(stopping, run.folder()).stopped);
    const RunSummary rest = run.run();
    EXPECT_GE(rest.scenes, kScenes - 2 * times);
    EXPECT_LE(rest.scenes, kScenes - 2 * times + 2) << "one waited for the next";
    EXPECT_EQ(rest.dataset_scenes, kScenes);
    SCOPED_TRACE("stopped after " + std::to_string(times));
    run.expectFiles(expected);
  }
}

TEST_F(PartsOfMotions, GiveTheBytesOfAllAtOnceInShards) {
  const Files expected = atOnce();
  for (const int index : {2, 0, 1}) (void)run.runShard(index, 3, run.folder());
  Reporter silent;
  mergeShards(run.folder(), {}, silent, {test::pluginXml()});
  run.expectFiles(expected);
}

TEST_F(PartsOfMotions, GiveTheSameBytesWhereNothingIsKept) {
  const Files expected = atOnce();
  run.parameters["rendering"] = yaml("{reuse: false}");
  (void)run.run();
  run.expectFiles(expected);
}

TEST_F(PartsOfMotions, MakeSomeScenesAlone) {
  const Files expected = atOnce();
  run.parameters["only_scenes"] = yaml("[9, 4, 6]");  // from all motions but the first
  EXPECT_EQ(run.run().scenes, 6) << "one a camera";
  int files = 0;
  for (const auto& [name, bytes] : AllAtOnceRun::files(run.folder())) {
    if (name == "manifest.sqlite") continue;
    ++files;
    EXPECT_TRUE(expected.count(name) == 1 && expected.at(name) == bytes) << name;
  }
  EXPECT_GT(files, 30);
  run.parameters.erase("only_scenes");
  EXPECT_EQ(run.run().scenes, kScenes - 6);
  run.expectFiles(expected);
}

TEST_F(PartsOfMotions, AreNotGoneThroughAgainWhenTheyAreComplete) {
  TimesReporter stopping(7);  // all of the first three motions
  EXPECT_TRUE(run.run(stopping, run.folder()).stopped);
  TimesReporter counter;
  (void)run.run(counter, run.folder());
  EXPECT_EQ(counter.times, 3 + kEnd) << "of ten times";
}

TEST_F(PartsOfMotions, AreGoneThroughUpToTheLastSceneThatIsWantedAlone) {
  TimesReporter counter;
  run.parameters["only_scenes"] = yaml("[0]");
  EXPECT_EQ(run.run(counter, run.folder()).scenes, 2);
  EXPECT_EQ(counter.times, 2 + kEnd) << "the next one tells where pixels go";
}

TEST_F(PartsOfMotions, CannotGoOnWithOthers) {
  TimesReporter stopping(2);
  (void)run.run(stopping, run.folder());
  (*run.parameters.at("motions").as<Value::List>()).pop_back();
  EXPECT_ANY_THROW((void)run.run());
}

}  // namespace motions_resumed_test
}  // namespace synthetic_dataset::run

/// Runs that are stopped and resumed.

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include <gmock/gmock.h>

#include "all_at_once_run.h"
#include "support/bag_builder.h"

namespace synthetic_dataset::run {
namespace resumed_run_test {

namespace fs = std::filesystem;
using test::AllAtOnceRun;
using test::StoppingReporter;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Key;

class ResumedRunTest : public ::testing::Test {
 protected:
  void stopAfter(std::int64_t scenes) const {
    StoppingReporter stopping(scenes);
    EXPECT_TRUE(run.run(stopping, run.folder()).stopped);
  }

  AllAtOnceRun run;
};

TEST_F(ResumedRunTest, GivesTheBytesOfAnUnbrokenOne) {
  const auto& unbroken = run.unbroken();
  ASSERT_GT(unbroken.size(), 150U);
  for (const std::int64_t scenes : {0, 2, 7, 16}) {
    fs::remove_all(run.folder());
    stopAfter(scenes);
    const RunSummary summary = run.run();
    EXPECT_EQ(summary.dataset_scenes, 16);
    EXPECT_EQ(summary.planned_scenes, 16);
    EXPECT_TRUE(AllAtOnceRun::files(run.folder()) == unbroken) << "stopped after " << scenes;
  }
}

/// A scene's warnings about the world do not depend on which scenes its process has made before.
TEST_F(ResumedRunTest, SaysTheSameOfAPropThatHasFallenOutOfTheWorld) {
  std::string world = test::readFile(run.input("tiny.world"));
  const std::string place = "<model name=\"ball\"><pose>0.3 -0.8";
  world.replace(world.find(place), place.size(),
                "<gravity>0 0 -60</gravity><model name=\"ball\"><pose>30 30");
  std::ofstream(run.input("tiny.world")) << world;
  const RunSummary whole = run.run();
  EXPECT_THAT(whole.warnings, Contains(Key(HasSubstr("'ball' has fallen out of the world"))));
  const auto& unbroken = run.unbroken();
  fs::remove_all(run.folder());
  stopAfter(13);
  (void)run.run();
  EXPECT_TRUE(AllAtOnceRun::files(run.folder()) == unbroken);
  fs::remove_all(run.folder());
  run.parameters["only_scenes"] = Value(Value::List{Value(7)});
  (void)run.run();
  run.parameters.erase("only_scenes");
  (void)run.run();
  EXPECT_TRUE(AllAtOnceRun::files(run.folder()) == unbroken);
}

TEST_F(ResumedRunTest, TellsOfTheWholeDataset) {
  const RunSummary unbroken = run.run();
  fs::remove_all(run.folder());
  stopAfter(6);
  const RunSummary resumed = run.run();
  EXPECT_LT(resumed.scenes, unbroken.scenes);
  EXPECT_EQ(resumed.files, unbroken.files);
  EXPECT_EQ(resumed.bytes, unbroken.bytes);
  EXPECT_EQ(resumed.warnings, unbroken.warnings);
  ASSERT_EQ(resumed.objects.size(), unbroken.objects.size());
  EXPECT_EQ(resumed.objects[0].scenes_seen, unbroken.objects[0].scenes_seen);
  EXPECT_EQ(resumed.objects[0].mask_agreement, unbroken.objects[0].mask_agreement);
}

TEST_F(ResumedRunTest, OfACompleteDatasetDoesNothing) {
  (void)run.run();
  const auto before = AllAtOnceRun::files(run.folder());
  const RunSummary summary = run.run();
  EXPECT_TRUE(summary.was_complete);
  EXPECT_EQ(summary.scenes, 0);
  EXPECT_EQ(lastLine(summary).rfind("done: the dataset was complete already", 0), 0U);
  EXPECT_TRUE(AllAtOnceRun::files(run.folder()) == before);
}

TEST_F(ResumedRunTest, OfACompleteDatasetMakesFilesAgainThatSomebodyRemoved) {
  (void)run.run();
  const auto before = AllAtOnceRun::files(run.folder());
  for (const auto& [name, bytes] : before) {
    const bool is_of_scene = name.find("00000002") != std::string::npos;
    const bool is_of_dataset = name.find(".txt") != std::string::npos && !is_of_scene;
    if (is_of_scene || is_of_dataset) fs::remove(fs::path(run.folder()) / name);
  }
  ASSERT_LT(AllAtOnceRun::files(run.folder()).size(), before.size());
  const RunSummary summary = run.run();
  EXPECT_FALSE(summary.was_complete);
  EXPECT_GT(summary.scenes, 0);
  for (const auto& [name, bytes] : AllAtOnceRun::files(run.folder())) {
    EXPECT_TRUE(before.count(name) == 1 && before.at(name) == bytes) << name;
  }
  EXPECT_EQ(AllAtOnceRun::files(run.folder()).size(), before.size());
}

TEST_F(ResumedRunTest, NamesTheSettingThatChanged) {
  stopAfter(2);
  const auto before = AllAtOnceRun::files(run.folder());
  run.parameters["seed"] = Value(8);
  EXPECT_THAT(run.errors(),
              Contains(AllOf(HasSubstr("seed: then 7, now 8"), HasSubstr("if_exists: overwrite"))));
  EXPECT_TRUE(AllAtOnceRun::files(run.folder()) == before);
}

TEST_F(ResumedRunTest, NamesTheInputThatChanged) {
  stopAfter(2);
  const std::string world = run.input("tiny.world");
  const std::string text = test::readFile(world);
  std::ofstream(world) << text << "<!-- the same, but for this -->";
  EXPECT_THAT(run.errors(), Contains(HasSubstr("the file " + world + ": then ")));
}

TEST_F(ResumedRunTest, NamesTheFileOfAnIncludedModelThatChanged) {
  std::string world = test::readFile(run.input("tiny.world"));
  world.insert(world.rfind("</world>"), "<include><uri>file://crate</uri></include>");
  std::ofstream(run.input("tiny.world")) << world;
  std::filesystem::create_directory(run.input("crate"));
  const std::map<std::string, std::string> texts = {
      {"model.config", "<model><sdf>model.sdf</sdf></model>"},
      {"model.sdf",
       "<sdf version='1.6'><model name='crate'><static>true</static><link name='body'><visual "
       "name='v'><geometry><mesh><uri>crate.obj</uri></mesh></geometry></visual></link></model>"
       "</sdf>"},
      {"crate.obj", "mtllib crate.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n"},
      {"crate.mtl", "newmtl red\nKd 1 0 0\n"}};
  const auto fileOf = [&](const std::string& name) { return run.input("crate") + "/" + name; };
  for (const auto& [name, text] : texts) std::ofstream(fileOf(name)) << text;
  stopAfter(2);
  for (const auto& [name, text] : texts) {
    std::ofstream(fileOf(name)) << text << "\n";
    EXPECT_THAT(run.errors(), Contains(HasSubstr("the file " + fileOf(name) + ": then "))) << name;
    std::ofstream(fileOf(name)) << text;
  }
  EXPECT_EQ(run.run().dataset_scenes, 16);
}

TEST_F(ResumedRunTest, MayWriteWithOtherCare) {
  stopAfter(2);
  run.parameters["sync"] = Value("scene");
  EXPECT_EQ(run.run().dataset_scenes, 16);
}

TEST_F(ResumedRunTest, ReplacesTheDatasetWhenAskedTo) {
  stopAfter(2);
  run.parameters["seed"] = Value(8);
  run.parameters["if_exists"] = Value("overwrite");
  EXPECT_EQ(run.run().scenes, 16);
}

}  // namespace resumed_run_test
}  // namespace synthetic_dataset::run

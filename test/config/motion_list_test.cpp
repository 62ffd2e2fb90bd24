#include "config/motion_list.h"

#include <string>

#include <gmock/gmock.h>

#include "base/yaml_value.h"

namespace synthetic_dataset::config {
namespace motion_list_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAre;

constexpr char kRun[] = R"(
robot_list: [rover, drone]
rover: {class: car, id: 1}
drone: {class: uav, id: 2}
bag_file: a.bag
world: {file: a.world}
seed: 3
camera: {info_file: c.yaml, pose: [1, 2]}
)";

/// The motions of a run with these entries.
MotionList motions(const std::string& entries, const std::string& more = "") {
  return readMotions(base::parseYaml(std::string(kRun) + more + "\nmotions: " + entries, "test"));
}

std::vector<std::string> errorsOf(const std::string& entries, const std::string& more = "") {
  return motions(entries, more).errors;
}

/// A setting of an entry; null if the entry does not have it.
Value setting(const MotionEntry& entry, const std::string& name) {
  const auto* settings = entry.settings.as<Value::Map>();
  const auto found = settings->find(name);
  return found == settings->end() ? Value() : found->second;
}

TEST(ReadMotions, WithoutAListTheRunIsTheOnlyOne) {
  const Value run = base::parseYaml(kRun + std::string("scenes: 5"), "test");
  const MotionList list = readMotions(run);
  EXPECT_THAT(list.errors, IsEmpty());
  ASSERT_THAT(list.entries, SizeIs(1));
  EXPECT_EQ(list.entries[0].group, "");
  EXPECT_EQ(list.entries[0].name, "0");
  EXPECT_EQ(list.entries[0].settings, run);
  EXPECT_FALSE(list.is_weighted);
  EXPECT_EQ(list.scenes, std::nullopt) << "they are the placement's";
}

TEST(ReadMotions, LaysEachEntryOverTheRun) {
  const MotionList list = motions("[{}, {bag_file: b.bag, camera: {pose: [3, 4]}}]");
  EXPECT_THAT(list.errors, IsEmpty());
  ASSERT_THAT(list.entries, SizeIs(2));
  EXPECT_EQ(list.entries[0].settings, base::parseYaml(kRun, "test"));
  EXPECT_EQ(setting(list.entries[1], "bag_file"), Value("b.bag"));
  EXPECT_EQ(setting(list.entries[1], "camera"),
            base::parseYaml("{info_file: c.yaml, pose: [3, 4]}", "test"));
  EXPECT_EQ(setting(list.entries[1], "seed"), Value(3));
  EXPECT_TRUE(setting(list.entries[1], "motions").isNull());
}

TEST(ReadMotions, TakesSlashesInAnEntry) {
  const MotionList list = motions("[{camera/far: 5, physics/settle: 1}]");
  EXPECT_THAT(list.errors, IsEmpty());
  EXPECT_EQ(setting(list.entries[0], "camera"),
            base::parseYaml("{info_file: c.yaml, pose: [1, 2], far: 5}", "test"));
}

TEST(ReadMotions, NamesEntriesByTheirPlaceUnlessTheyHaveAName) {
  const MotionList list = motions("[{}, {name: yard}, {}]");
  EXPECT_THAT(list.errors, IsEmpty());
  EXPECT_EQ(list.entries[0].name, "0");
  EXPECT_EQ(list.entries[1].name, "yard");
  EXPECT_EQ(list.entries[2].name, "2");
  EXPECT_EQ(list.entries[1].group, "motions/1");
}

TEST(ReadMotions, TakesWhatIsAboutTheEntryOutOfItsSettings) {
  const MotionList list = motions("[{name: a, weight: 2, split: val, robot_list: [/rover]}, {}]");
  EXPECT_THAT(list.errors, IsEmpty());
  EXPECT_EQ(list.entries[0].weight, 2.0);
  EXPECT_EQ(list.entries[0].split, "val");
  EXPECT_THAT(list.entries[0].objects, ElementsAre("rover"));
  EXPECT_EQ(list.entries[0].settings, base::parseYaml(kRun, "test"))
      << "the run's robot_list stays";
  EXPECT_EQ(list.entries[1].weight, 1.0);
  EXPECT_EQ(list.entries[1].split, std::nullopt);
  EXPECT_THAT(list.entries[1].objects, IsEmpty());
}

// --- How many scenes ---

TEST(ReadMotions, GivesAllThatThereIsWithoutWeights) {
  EXPECT_FALSE(motions("[{}, {name: b}]").is_weighted);
}

TEST(ReadMotions, IsWeightedWhereAnEntryHasAWeight) {
  const MotionList list = motions("[{}, {weight: 0.5}]");
  EXPECT_TRUE(list.is_weighted);
  EXPECT_EQ(list.scenes, std::nullopt);
}

TEST(ReadMotions, IsWeightedWhereTheNumberOfAllIsGiven) {
  const MotionList list = motions("[{}, {}]", "scenes: 100");
  EXPECT_THAT(list.errors, IsEmpty());
  EXPECT_TRUE(list.is_weighted);
  EXPECT_EQ(list.scenes, 100);
  EXPECT_TRUE(setting(list.entries[0], "scenes").isNull()) << "it is not the entry's";
}

TEST(ReadMotions, LetsAPlacementHaveAsManyAsAreNeeded) {
  const MotionList list =
      motions("[{}, {motion: placement}, {motion: placement, scenes: 7}]", "scenes: 100");
  EXPECT_THAT(list.errors, IsEmpty());
  EXPECT_TRUE(setting(list.entries[0], "scenes").isNull());
  EXPECT_EQ(setting(list.entries[1], "scenes"), Value(100));
  EXPECT_EQ(setting(list.entries[2], "scenes"), Value(7));
}

TEST(ReadMotions, NamesNumbersOfScenesThatMeanNothing) {
  EXPECT_THAT(errorsOf("[{}]", "scenes: 0"),
              ElementsAre("scenes: found 0; it should be 1 to 100000000"));
  EXPECT_THAT(errorsOf("[{}]", "scenes: many"), ElementsAre(HasSubstr("scenes: found ")));
}

TEST(ReadMotions, NamesAWeightThatIsNone) {
  for (const char* weight : {"0", "-1.5"}) {
    EXPECT_THAT(errorsOf("[{}, {weight: " + std::string(weight) + "}]"),
                ElementsAre(HasSubstr("motions/1/weight: found " + std::string(weight))));
  }
  EXPECT_THAT(errorsOf("[{weight: heavy}]"), ElementsAre(HasSubstr("motions/0/weight: found ")));
}

// --- Settings of one kind of motion ---

TEST(ReadMotions, KeepsTheRecordingsSettingsFromPlacementsAndTheOtherWayRound) {
  const MotionList list =
      motions("[{}, {motion: placement, scenes: 3}]",
              "start_offset: 1\nduration: 2\nmax_tf_gap: 3\nplacement: {map: m.yaml}");
  EXPECT_THAT(list.errors, IsEmpty());
  for (const char* name : {"start_offset", "duration", "max_tf_gap"}) {
    EXPECT_FALSE(setting(list.entries[0], name).isNull()) << name;
    EXPECT_TRUE(setting(list.entries[1], name).isNull()) << name;
  }
  EXPECT_TRUE(setting(list.entries[0], "placement").isNull());
  EXPECT_FALSE(setting(list.entries[1], "placement").isNull());
}

TEST(ReadMotions, LeavesSettingsThatNoMotionCanHave) {
  // They are errors, as they are without a list.
  const MotionList list = motions("[{}, {name: b}]", "placement: {map: m.yaml}");
  EXPECT_FALSE(setting(list.entries[0], "placement").isNull());
  EXPECT_FALSE(setting(list.entries[1], "placement").isNull());
}

TEST(ReadMotions, LetsAnEntryFollowARecordingWhereTheRunPlaces) {
  const MotionList list =
      motions("[{}, {motion: bag}]", "motion: placement\nplacement: {map: m.yaml}\nduration: 2");
  EXPECT_TRUE(setting(list.entries[0], "duration").isNull());
  EXPECT_FALSE(setting(list.entries[0], "placement").isNull());
  EXPECT_FALSE(setting(list.entries[1], "duration").isNull());
  EXPECT_TRUE(setting(list.entries[1], "placement").isNull());
}

// --- Errors ---

TEST(ReadMotions, NamesWhatIsNoList) {
  EXPECT_THAT(errorsOf("{a: {bag_file: b.bag}}"),
              ElementsAre("motions: found a group; it should be a list of groups of settings, one "
                          "for each motion"));
  EXPECT_THAT(errorsOf("a.bag"), ElementsAre(HasSubstr("motions: found a text; ")));
  EXPECT_THAT(motions("a.bag").entries, SizeIs(1)) << "other errors are found with it";
}

TEST(ReadMotions, NamesAnEmptyList) {
  EXPECT_THAT(errorsOf("[]"),
              ElementsAre("motions: found an empty list; it should have at least one motion"));
}

TEST(ReadMotions, NamesAnEntryThatIsNoGroup) {
  EXPECT_THAT(errorsOf("[{name: a}, b.bag]"),
              ElementsAre("motions/1: found a text; it should be a group of settings, such as "
                          "{bag_file: walk.bag}"));
}

TEST(ReadMotions, NamesANameThatTwoEntriesHave) {
  EXPECT_THAT(errorsOf("[{name: a}, {name: b}, {name: a}]"),
              ElementsAre("motions/2/name: found 'a' more than once; each motion should have its "
                          "own"));
  EXPECT_THAT(errorsOf("[{name: '1'}, {}]"), ElementsAre(HasSubstr("motions/1/name: found '1'")));
}

TEST(ReadMotions, NamesANameOfSeveralLines) {
  EXPECT_THAT(errorsOf("[{name: \"a\\nb\"}]"),
              ElementsAre(HasSubstr("it should be a text of one line")));
  EXPECT_THAT(errorsOf("[{name: ''}]"), ElementsAre(HasSubstr("it should be a text of one line")));
}

TEST(ReadMotions, NamesASplitThatIsNone) {
  EXPECT_THAT(errorsOf("[{split: tests}]"),
              ElementsAre("motions/0/split: found 'tests'; it should be train, val or test; "
                          "did you mean 'test'?"));
}

TEST(ReadMotions, NamesAnObjectThatTheRunDoesNotHave) {
  EXPECT_THAT(errorsOf("[{robot_list: [rover, drome]}, {}]"),
              ElementsAre("motions/0/robot_list: found 'drome', which the run's robot_list does "
                          "not have; it should name all objects of all motions; did you mean "
                          "'drone'?"));
  EXPECT_THAT(errorsOf("[{robot_list: []}]"),
              ElementsAre(HasSubstr("motions/0/robot_list: found an empty list")));
}

TEST(ReadMotions, NamesAnObjectThatTakesPartInNone) {
  EXPECT_THAT(errorsOf("[{robot_list: [rover]}, {robot_list: [rover]}]"),
              ElementsAre("robot_list: found 'drone', which no motion's robot_list has"));
}

TEST(ReadMotions, NamesSettingsOfTheWholeDataset) {
  const std::string should = ": is a setting of the whole dataset; it should stand beside motions";
  EXPECT_THAT(errorsOf("[{seed: 4, writers: [], global_frame: odom}]", "writers: []"),
              UnorderedElementsAre("motions/0/seed" + should, "motions/0/writers" + should,
                                   "motions/0/global_frame" + should));
}

TEST(ReadMotions, NamesUnknownParameters) {
  EXPECT_TRUE(setting(motions("[{drivel: 7}]").entries[0], "drivel").isNull()) << "told already";
  EXPECT_THAT(errorsOf("[{bag_fil: b.bag}]"),
              ElementsAre("motions/0/bag_fil: unknown parameter; did you mean 'bag_file'?"));
}

TEST(ReadMotions, LetsAnObjectHaveAnotherFrame) {
  const MotionList list = motions("[{rover: {frame: robot_7, safety_radius: 1}}]");
  EXPECT_THAT(list.errors, IsEmpty());
  EXPECT_EQ(setting(list.entries[0], "rover"),
            base::parseYaml("{class: car, id: 1, frame: robot_7, safety_radius: 1}", "test"));
}

TEST(ReadMotions, LetsAnObjectBeNothingElse) {
  EXPECT_THAT(errorsOf("[{rover: {class: truck}}]"),
              ElementsAre("motions/0/rover/class: an object is the same in all motions, but for "
                          "frame, frame_id, link_frames, safety_radius and when_unknown; it should "
                          "stand in the run's group 'rover'"));
  EXPECT_THAT(errorsOf("[{rover: car}]"),
              ElementsAre("motions/0/rover: found a text; it should be a group of settings"));
}

TEST(ReadMotions, NamesEverythingAtOnce) {
  EXPECT_THAT(errorsOf("[{weight: 0, split: dev}, 7, {seed: 1}]"), SizeIs(4));
}

}  // namespace motion_list_test
}  // namespace synthetic_dataset::config

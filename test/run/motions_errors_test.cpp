/// Errors of runs with several motions.

#include <gmock/gmock.h>

#include "motions_run.h"

namespace synthetic_dataset::run {
namespace motions_errors_test {

using test::MotionsRun;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

class MotionsErrors : public ::testing::Test {
 protected:
  MotionsRun run;
};

TEST_F(MotionsErrors, AreNoneWhereAllIsRight) {
  run.list("[{}, {bag_file: DIR/other.bag, world: DIR/yard.world}]");
  EXPECT_THAT(run.errors(), IsEmpty());
}

TEST_F(MotionsErrors, OfAllAreToldOnce) {
  run.set("world", "DIR/nowhere.world");
  run.set("simulated_rate", "-1");
  run.set("nonsense", "1");
  run.list("[{}, {bag_file: DIR/other.bag}]");
  EXPECT_THAT(run.errors(),
              ElementsAre(StartsWith("simulated_rate: found -1"),
                          StartsWith("nonsense: unknown parameter"), HasSubstr("nowhere.world")));
}

TEST_F(MotionsErrors, OfOneAreToldWithItsPlaceInTheList) {
  run.list("[{}, {bag_file: DIR/none.bag}, {world: DIR/none.world}, {simulated_rate: 0}]");
  EXPECT_THAT(run.errors(), ElementsAre(StartsWith("motions/3: simulated_rate: found 0"),
                                        AllOf(StartsWith("motions/1: "), HasSubstr("none.bag")),
                                        AllOf(StartsWith("motions/2: "), HasSubstr("none.world"))));
}

TEST_F(MotionsErrors, OfWritersAreToldOnce) {
  run.set("bounding_shape", "{output_frame: map, precision: 3}");
  run.set("yolo", "{main_list: list.txt, cut_to_image: 7}");
  run.list("[{}, {}]");
  EXPECT_THAT(run.errors(), ElementsAre(StartsWith("yolo/cut_to_image: found "),
                                        StartsWith("bounding_shape/precision: unknown")));
}

TEST_F(MotionsErrors, NameFramesThatARecordingDoesNotHave) {
  run.set("bounding_shape", "{output_frame: bravo/base_link}");
  run.list("[{}, {robot_list: [alpha], bag_file: DIR/lone.bag}]");
  EXPECT_THAT(run.errors(), ElementsAre(StartsWith("motions/1: a writer asks for the frame "
                                                   "'bravo/base_link': the recording has no "
                                                   "frame")));
}

TEST_F(MotionsErrors, NameParametersThatNobodyReads) {
  run.list("[{}, {camera: {faar: 3}, physics: {stepp: 1}, drivel: 7}]");
  EXPECT_THAT(run.errors(),
              ElementsAre("motions/1: camera/faar: unknown parameter; did you mean 'far'?",
                          "motions/1: physics/stepp: unknown parameter; did you mean 'step'?",
                          "motions/1/drivel: unknown parameter"));
}

TEST_F(MotionsErrors, NameSettingsOfTheOtherKindOfMotion) {
  run.list("[{}, {scenes: 5}]");
  EXPECT_THAT(run.errors(), Contains(StartsWith("motions/1: scenes: ")));
  run.list(
      "[{}, {motion: placement, scenes: 2, duration: 3, placement: {mode: volume, volume: "
      "{min: [0, 0, 1], max: [1, 1, 2]}}}]");
  EXPECT_THAT(run.errors(), Contains(StartsWith("motions/1: duration: ")));
}

TEST_F(MotionsErrors, AreNoneForSettingsOfTheRunThatOneKindOfMotionHas) {
  run.set("start_offset", "0.2");
  run.set("max_tf_gap", "2");
  run.set("placement", "{mode: volume, volume: {min: [0, 0, 1], max: [1, 1, 2]}}");
  run.list("[{}, {motion: placement, scenes: 2}]");
  EXPECT_THAT(run.errors(), IsEmpty());
}

TEST_F(MotionsErrors, OfTheListStandBesideThoseOfTheSettings) {
  run.set("simulated_rate", "-1");
  run.list("[{weight: 0}, {seed: 1, global_frame: odom}, 5]");
  EXPECT_THAT(run.errors(),
              ElementsAre(StartsWith("simulated_rate: "), StartsWith("motions/0/weight: "),
                          StartsWith("motions/1/global_frame: "), StartsWith("motions/1/seed: "),
                          StartsWith("motions/2: ")));
}

TEST_F(MotionsErrors, NameWhatIsNoListBesideOthers) {
  run.set("world", "DIR/nowhere.world");
  run.set("motions", "{a: {}}");
  EXPECT_THAT(run.errors(), ElementsAre(HasSubstr("nowhere.world"),
                                        StartsWith("motions: found a group; it should be a list")));
  run.list("[]");
  EXPECT_THAT(run.errors(), Contains(StartsWith("motions: found an empty list")));
}

TEST_F(MotionsErrors, SayNothingElseOfAListThatIsWrong) {
  run.set("scenes", "9");
  run.list("[]");
  EXPECT_THAT(run.errors(), ElementsAre(StartsWith("motions: found an empty list")));
  run.set("motions", "{a: 1}");
  EXPECT_THAT(run.errors(), ElementsAre(StartsWith("motions: found a group; it should be")));
}

TEST_F(MotionsErrors, NameAMotionWithTooFewScenes) {
  run.set("scenes", "9");
  run.list("[{}, {bag_file: DIR/other.bag, weight: 2}]");
  EXPECT_THAT(run.errors(),
              ElementsAre(StartsWith("motions/1/weight: found 2.0 of 3.0 in all, which is 6 of the "
                                     "9 scenes; this motion has 2")));
}

TEST_F(MotionsErrors, NameCamerasOfOtherNames) {
  const std::string camera = "{info_file: DIR/camera.yaml, pose: [0, 0, 1, 0, 0, 0, 1]}";
  run.list("[{}, {cameras: {left: " + camera + ", right: " + camera + "}}]");
  EXPECT_THAT(run.errors(),
              ElementsAre("motions/1/cameras: found 'left', 'right'; motions/0 has 'camera', and "
                          "all motions should have cameras of the same names"));
}

TEST_F(MotionsErrors, NameAnObjectThatAMotionsWorldLacks) {
  run.list("[{}, {world: DIR/lone.world}]");
  EXPECT_THAT(run.errors(),
              ElementsAre(AllOf(StartsWith("motions/1: bravo/model: found none, and the world '"),
                                HasSubstr("has no model 'bravo'"))));
}

TEST_F(MotionsErrors, NameCamerasOnOrAimedAtWhatDoesNotTakePart) {
  run.list("[{}, {robot_list: [alpha], camera: {mounted_on: bravo, pose: [0, 0, 1, 0, 0, 0, 1]}}]");
  EXPECT_THAT(run.errors(), ElementsAre(AllOf(StartsWith("motions/1: camera/mounted_on: "),
                                              HasSubstr("'bravo'"))));
  run.list("[{}, {robot_list: [alpha], camera: {sample: {look_at: bravo}}}]");
  EXPECT_THAT(run.errors(), ElementsAre(AllOf(StartsWith("motions/1: camera/sample/look_at: "),
                                              HasSubstr("'bravo'"))));
}

TEST_F(MotionsErrors, NameASplitThatIsLacking) {
  run.list("[{split: test}, {}]");
  EXPECT_THAT(run.errors(), ElementsAre(StartsWith("split: missing; some of the motions")));
}

TEST_F(MotionsErrors, NameScenesThatAllMotionsTogetherDoNotHave) {
  run.set("only_scenes", "[5, 6]");
  run.list("[{}, {bag_file: DIR/other.bag}]");
  EXPECT_THAT(run.errors(), ElementsAre("only_scenes: found 6; this run's scenes are 0 to 5"));
}

TEST_F(MotionsErrors, OfAPlacementNameIt) {
  run.list("[{}, {motion: placement}]");
  EXPECT_THAT(run.errors(), AllOf(Contains(StartsWith("motions/1: scenes: ")),
                                  Contains(StartsWith("motions/1: placement"))));
}

}  // namespace motions_errors_test
}  // namespace synthetic_dataset::run

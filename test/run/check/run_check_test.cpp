/// Runs that are odd on purpose, each by one mistake of a user, and runs that are not.

#include "run/check/run_check.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "config/settings_file.h"
#include "run/run_fixture.h"
#include "support/bag_builder.h"
#include "support/error_messages.h"
#include "support/source_folder.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::run {
namespace run_check_test {

using test::milliseconds;
using test::poseAt;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;

constexpr const char* kCrate =
    "<model name='crate'><static>true</static><pose>%POSE%</pose><link name='body'>"
    "<visual name='v'><geometry><box><size>%SIZE%</size></box></geometry></visual></link></model>";

class RunCheckTest : public test::RunFixture {
 protected:
  RunCheckTest() { parameters["masks"] = Value(Value::Map{{"method", Value("exact")}}); }

  [[nodiscard]] RunCheck check() const {
    Reporter silent;
    return checkRun(Value(parameters), silent, {test::pluginXml()});
  }

  /// "<kind> | <message>" of each finding.
  [[nodiscard]] std::vector<std::string> odd() const {
    std::vector<std::string> lines;
    for (const Finding& each : check().findings)
      lines.push_back(each.kind + " | " + each.message());
    return lines;
  }

  /// The warnings of the run's scenes.
  [[nodiscard]] std::vector<std::string> warnings() const {
    WarningList reporter;
    (void)checkRun(Value(parameters), reporter, {test::pluginXml()});
    return reporter.messages;
  }

  Value::Map& camera() { return *parameters.at("camera").as<Value::Map>(); }

  static Value vector(double x, double y, double z) {
    return Value(Value::List{Value(x), Value(y), Value(z)});
  }

  /// A camera somewhere that looks at alpha, or at a point.
  void look(const Value& from, const Value& at = Value("alpha")) {
    camera()["pose"] = Value(Value::Map{{"position", from}, {"look_at", at}});
  }

  void replaceInWorld(const std::string& what, const std::string& by) {
    std::string world = test::readFile(run.folder() / "tiny.world");
    ASSERT_NE(world.find(what), std::string::npos) << what;
    for (std::size_t at = world.find(what); at != std::string::npos;
         at = world.find(what, at + by.size())) {
      world.replace(at, what.size(), by);
    }
    run.folder().write("tiny.world", world);
  }

  void addToWorld(const std::string& what) { replaceInWorld("</world>", what + "</world>"); }

  void addCrate(const std::string& pose, const std::string& size) {
    std::string crate = kCrate;
    crate.replace(crate.find("%POSE%"), 6, pose);
    crate.replace(crate.find("%SIZE%"), 6, size);
    addToWorld(crate);
  }

  /// Records a second in which alpha has the given poses and bravo drives along.
  void record(const std::function<Pose(double seconds)>& alpha) {
    test::BagBuilder bag(run.folder() / "tiny.bag");
    for (int i = 0; i <= 20; ++i) {
      const Stamp time = milliseconds(1000 + 50 * i);
      bag.move("map", "alpha/base_link", time, alpha(0.05 * i));
      bag.move("map", "bravo/base_link", time, poseAt(0.0, 1.0 + 0.02 * i, 0.0));
    }
    bag.close();
  }
};

TEST_F(RunCheckTest, ASoundRunHasNothingOddAndLeavesNoDataset) {
  const RunCheck found = check();
  EXPECT_THAT(odd(), IsEmpty());
  EXPECT_THAT(found.scenes, SizeIs(4)) << "all that there are";
  EXPECT_THAT(planLines(found.setup, found.figures),
              AllOf(Contains(HasSubstr("times: 4 from 1.000 s to 1.750 s")),
                    Contains(HasSubstr("scenes: 4, of camera (160 x 120)")),
                    Contains(HasSubstr("formats: ")), Contains(HasSubstr("of disk"))));
  EXPECT_GT(found.figures.bytes, 1000);
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST_F(RunCheckTest, AWallBeforeTheCameraIsNamed) {
  addCrate("-1.5 0 0.5 0 0 0", "0.1 6 4");
  EXPECT_THAT(odd(),
              Contains(AllOf(HasSubstr("not seen | alpha: seen in none of 4 scenes: hidden by "
                                       "'crate' in 4"),
                             HasSubstr("look_at: alpha"))));
}

TEST_F(RunCheckTest, ACameraThatLooksAwayIsNamed) {
  look(vector(-3.0, 0.2, 0.5), vector(-6.0, 0.2, 0.5));
  EXPECT_THAT(odd(), Contains(HasSubstr("not seen | alpha: seen in none of 4 scenes: behind the "
                                        "camera in 4")));
  look(vector(-3.0, 0.2, 0.5), vector(-3.0, 0.2, 5.0));
  EXPECT_THAT(odd(), Contains(HasSubstr("plain | pictures: 4 of 4 scenes are of one colour")));
}

TEST_F(RunCheckTest, AnObjectBesideThePictureIsNamed) {
  look(vector(-3.0, -3.0, 0.5), vector(-3.0, 5.0, 0.5));
  EXPECT_THAT(odd(), Contains(HasSubstr("not seen | alpha: seen in none of 4 scenes: outside the "
                                        "picture in 4")));
}

TEST_F(RunCheckTest, AnObjectBehindAnotherIsNamed) {
  test::BagBuilder bag(run.folder() / "tiny.bag");
  bag.fix("map", "alpha/base_link", milliseconds(1000), poseAt(0.0, 0.0, 0.0));
  bag.fix("map", "bravo/base_link", milliseconds(1000), poseAt(-1.5, 0.0, 0.0));
  bag.move("map", "other", milliseconds(1000)).move("map", "other", milliseconds(2000));
  bag.close();
  look(vector(-3.0, 0.0, 0.2));
  EXPECT_THAT(odd(), Contains(HasSubstr("not seen | alpha: seen in none of 4 scenes: hidden by "
                                        "'bravo' in 4")));
}

TEST_F(RunCheckTest, AnObjectBeyondTheFarPlaneIsNamed) {
  camera()["far"] = Value(2.0);
  EXPECT_THAT(odd(), Contains(HasSubstr("not seen | alpha: seen in none of 4 scenes: beyond "
                                        "camera/far in 4")));
}

TEST_F(RunCheckTest, ARunSaysThatAnObjectIsBeyondTheFarPlane) {
  camera()["far"] = Value(2.0);
  EXPECT_THAT(warnings(), Contains(HasSubstr("'alpha' is in view, and beyond camera/far, 2 m")));
}

TEST_F(RunCheckTest, ACameraOnTheFrameOfItsBodyIsNamed) {
  test::BagBuilder bag(run.folder() / "tiny.bag");
  bag.fix("map", "camera_link", milliseconds(1000), poseAt(-3.0, 0.0, 0.5));
  bag.fix("map", "bravo/base_link", milliseconds(1000), poseAt(0.0, 1.0, 0.0));
  bag.move("map", "alpha/base_link", milliseconds(1000), poseAt(0.0, 0.0, 0.0));
  bag.move("map", "alpha/base_link", milliseconds(2000), poseAt(0.0, 0.2, 0.0));
  bag.close();
  camera().erase("pose");
  camera()["frame_id"] = Value("camera_link");
  EXPECT_THAT(odd(), Contains(HasSubstr("body frame | camera: its frame 'camera_link' looks "
                                        "straight up all the time")));
}

TEST_F(RunCheckTest, AnObjectThatIsHardlySeenIsNamed) {
  record([](double t) { return poseAt(0.0, t < 0.03 ? 0.0 : 3.5, 0.0); });
  parameters["simulated_rate"] = Value(20.0);
  look(vector(-3.0, 0.2, 0.5), vector(0.0, 0.2, 0.2));
  EXPECT_THAT(odd(), Contains(HasSubstr("not seen | alpha: seen in 1 of 9 scenes: outside the "
                                        "picture in 8")));
}

TEST_F(RunCheckTest, AnObjectTooFarAwayIsNamed) {
  look(vector(-150.0, 0.2, 20.0));
  EXPECT_THAT(odd(), Contains(HasSubstr("smaller than a pixel")));
}

TEST_F(RunCheckTest, AnObjectThatIsLookedAtAlreadyIsNotToBeLookedAt) {
  look(vector(-150.0, 0.2, 20.0));
  EXPECT_THAT(odd(), Contains(AllOf(HasSubstr("not seen | alpha: "),
                                    HasSubstr("the camera looks at it already: a nearer position"),
                                    HasSubstr("millimetres"), Not(HasSubstr("aims the camera")))));
}

TEST_F(RunCheckTest, APictureThatIsUpsideDownIsNamed) {
  // Half a turn about the optical axis of the camera that looks along x.
  camera()["pose"] = Value(Value::List{Value(-3.0), Value(0.2), Value(0.5), Value(0.5), Value(0.5),
                                       Value(0.5), Value(0.5)});
  EXPECT_THAT(odd(), Contains(AllOf(HasSubstr("upside down | camera: its picture is upside down in "
                                              "4 of 4 scenes"),
                                    HasSubstr("deg(180)"))));
}

TEST_F(RunCheckTest, WhatHangsInTheAirByChanceIsNamed) {
  for (const char* name : {"bag_file", "simulated_rate"}) parameters.erase(name);
  parameters["motion"] = Value("placement");
  parameters["scenes"] = Value(4);
  parameters["placement"] = Value(Value::Map{
      {"mode", Value("volume")},
      {"orientation", Value("upright")},
      {"volume",
       Value(Value::Map{{"min", vector(-1.0, -1.0, 0.5)}, {"max", vector(1.0, 1.0, 1.5)}})}});
  EXPECT_THAT(odd(), Contains(AllOf(HasSubstr("hangs | alpha: hangs in the air above 'floor'"),
                                    HasSubstr("`placement: {mode: ground}`"))));
  parameters["placement"] = Value(Value::Map{{"mode", Value("ground")}});
  EXPECT_THAT(odd(), Not(Contains(HasSubstr("hangs |"))));
}

TEST_F(RunCheckTest, ASplitWithoutLabelsIsNamed) {
  record([](double t) { return poseAt(0.0, t < 0.6 ? 0.0 : 9.0, 0.0); });
  parameters["robot_list"] = Value(Value::List{Value("alpha")});
  parameters["simulated_rate"] = Value(20.0);
  parameters["split"] = Value(Value::Map{{"train", Value(0.7)}, {"val", Value(0.3)}});
  EXPECT_THAT(odd(), Contains(AllOf(HasSubstr("split without labels | split: val would have no "
                                              "label at all"),
                                    HasSubstr("`split/by: balanced_blocks`"))));
  const RunCheck found = check();
  EXPECT_THAT(splitLine(found.setup, found.splits),
              AllOf(HasSubstr("train 12 box"), HasSubstr("val 0 box")));
  (*parameters["split"].as<Value::Map>())["by"] = Value("balanced_blocks");
  EXPECT_THAT(odd(), Not(Contains(HasSubstr("split without labels"))));
}

TEST_F(RunCheckTest, FilesOfOthersThatTheRunWouldRefuseAreNamed) {
  std::filesystem::create_directories(folder + "/yolo");
  std::ofstream(folder + "/yolo/0.txt") << "mine";
  EXPECT_THAT(odd(),
              Contains(AllOf(HasSubstr("files in the way | output_folder: "), HasSubstr("0.txt"))));
  EXPECT_THAT(errors(), Contains(HasSubstr("0.txt")));
}

TEST_F(RunCheckTest, FilesThatMayBeMissingAreOneLineAtTheEnd) {
  for (const char* name : {"tree", "bench"}) {
    addToWorld("<include><uri>model://" + std::string(name) + "_of_nobody</uri></include>");
  }
  parameters["world"] =
      Value(Value::Map{{"file", parameters.at("world")}, {"on_missing_asset", Value("warn")}});
  const std::vector<std::string> lines = odd();
  ASSERT_THAT(lines, SizeIs(1));
  EXPECT_THAT(lines.back(), AllOf(StartsWith("missing files | world: 2 files are missing"),
                                  HasSubstr("tree_of_nobody")));
}

TEST_F(RunCheckTest, TinyLabelsAreNamedWithTheirCure) {
  look(vector(-16.0, 0.5, 1.0));
  EXPECT_THAT(odd(), Contains(AllOf(HasSubstr("tiny labels | labels: "),
                                    HasSubstr("`labels/min_pixels: 25`"))));
  parameters["labels"] = Value(Value::Map{{"min_pixels", Value(25)}});
  EXPECT_THAT(odd(), Not(Contains(HasSubstr("tiny labels"))));
}

TEST_F(RunCheckTest, AModelInAnotherUnitIsNamed) {
  replaceInWorld("0.4 0.4 0.4", "390 390 390");
  EXPECT_THAT(odd(), Contains(AllOf(HasSubstr("size | alpha: its model is 390.0 x 390.0 x 390.0 m"),
                                    HasSubstr("0.001 0.001 0.001"))));
  replaceInWorld("390 390 390", "0.0004 0.0004 0.0004");
  EXPECT_THAT(odd(), Contains(HasSubstr("size | alpha: its model is 0.00040 x ")));
}

TEST_F(RunCheckTest, KeypointsOutsideOfTheModelAreNamed) {
  Value::Map& alpha = *parameters.at("alpha").as<Value::Map>();
  alpha["keypoints"] = Value(Value::List{vector(0.2, 0.0, 0.9)});
  EXPECT_THAT(odd(), Contains(HasSubstr("alpha/keypoints: one is 0.500 m away from the model")));
}

TEST_F(RunCheckTest, ACameraInsideOfSomethingIsNamed) {
  addCrate("-3 0.2 0.5 0 0 0", "1 1 1");
  EXPECT_THAT(odd(), Contains(HasSubstr("camera's place | camera: is inside of 'crate' in 4 of 4 "
                                        "scenes, first at [-3.00, 0.20, 0.50]")));
}

TEST_F(RunCheckTest, ACameraRightBeforeAWallIsNamed) {
  addCrate("-2.85 0.2 0.5 0 0 0", "0.1 6 4");
  EXPECT_THAT(odd(),
              Contains(HasSubstr("has 'crate' less than 0.15 m in front of most of its lens")));
}

TEST_F(RunCheckTest, ACameraBelowTheGroundIsNamed) {
  addToWorld(
      "<model name='earth'><static>true</static><pose>0 0 -0.5 0 0 0</pose><link name='l'>"
      "<collision name='c'><geometry><plane><normal>0 0 1</normal></plane></geometry></collision>"
      "</link></model>");
  look(vector(-3.0, 0.2, -0.8));
  EXPECT_THAT(odd(), Contains(HasSubstr("camera: is below 'earth'")));
}

TEST_F(RunCheckTest, ARoomThatIsOneShellIsNoThingToBeInsideOf) {
  addCrate("0 0 2 0 0 0", "20 20 8");
  EXPECT_THAT(odd(), Not(Contains(HasSubstr("camera's place"))));
}

TEST_F(RunCheckTest, AWorldWithoutLightIsNamed) {
  replaceInWorld("<light name=\"sun\"",
                 "<scene><ambient>0 0 0 1</ambient><background>0 0 0 1"
                 "</background></scene><light name=\"sun\"");
  replaceInWorld("<diffuse>0.8 0.8 0.8 1</diffuse></light>",
                 "<diffuse>0 0 0 1</diffuse><specular>0 0 0 1</specular></light>");
  EXPECT_THAT(odd(), Contains(AllOf(HasSubstr("dark | pictures: 4 of 4 scenes are nearly black"),
                                    HasSubstr("may lack a light"))));
}

TEST_F(RunCheckTest, PicturesThatAreWhiteAreNamed) {
  camera()["effects"] = Value(Value::Map{{"exposure", Value(10.0)}});
  EXPECT_THAT(odd(), Contains(HasSubstr("bright | pictures: 4 of 4 scenes are nearly white")));
}

TEST_F(RunCheckTest, AGroundThatEndsIsNamed) {
  record([](double t) { return poseAt(0.0, 2.9 + 2.0 * t, 0.0); });
  EXPECT_THAT(odd(), Contains(AllOf(HasSubstr("no ground | alpha: nothing of the world is below it "
                                              "at 1 of 4 times, first at 1.750 s, where it stands "
                                              "at [0.00, 4.40, 0.00]"),
                                    HasSubstr("the ground may end there"))));
}

TEST_F(RunCheckTest, AGroundThatEndsIsNamedThoughItsCollisionHasNoEnd) {
  // Like Gazebo's own ground_plane: a visual of 100 m, and an infinite plane for physics.
  replaceInWorld("<geometry><box><size>8 8 0.2</size></box></geometry></collision>",
                 "<geometry><plane><normal>0 0 1</normal><size>8 8</size></plane></geometry>"
                 "</collision>");
  record([](double t) { return poseAt(0.0, 2.9 + 2.0 * t, 0.0); });
  EXPECT_THAT(odd(), Contains(HasSubstr("no ground | alpha: nothing of the world is below it at 1 "
                                        "of 4 times")));
}

TEST_F(RunCheckTest, AWayThroughAWallIsNamed) {
  addCrate("0 0 1 0 0 0", "4 0.1 2");
  record([](double t) { return poseAt(0.0, -0.5 + t, 0.0); });
  parameters["simulated_rate"] = Value(20.0);
  EXPECT_THAT(odd(), Contains(AllOf(HasSubstr("in walls | alpha: is inside parts of the world at "),
                                    HasSubstr("of 20 times, first in 'crate'"))));
  record([](double t) { return poseAt(0.0, -1.5 + t, 0.0); });
  EXPECT_THAT(odd(), Not(Contains(HasSubstr("in walls")))) << "it is before the wall";
}

TEST_F(RunCheckTest, WhatSinksOrFloatsIsNamed) {
  record([](double t) { return poseAt(0.0, -0.5 + t, -0.12); });
  EXPECT_THAT(odd(),
              Contains(HasSubstr("sinks | alpha: sinks 0.12 m into 'floor' nearly all the time")));
  record([](double t) { return poseAt(0.0, -0.5 + t, 0.13); });
  EXPECT_THAT(odd(), Contains(AllOf(HasSubstr("floats | alpha: floats 0.13 m above 'floor'"),
                                    HasSubstr("base_footprint"))));
  record([](double t) { return poseAt(0.0, -0.5 + t, 0.1 + 0.2 * t); });
  EXPECT_THAT(odd(), Not(Contains(HasSubstr("floats |")))) << "it flies";
}

TEST_F(RunCheckTest, ALightInsideOfSomethingIsNamed) {
  addCrate("1 2 3 0 0 0", "1 1 1");
  addToWorld(
      "<light name='lamp' type='spot'><pose>1 2 3.2 0 0 0</pose><cast_shadows>true</cast_shadows>"
      "<diffuse>1 1 1 1</diffuse><attenuation><range>10</range></attenuation><spot>"
      "<inner_angle>0.5</inner_angle><outer_angle>0.9</outer_angle><falloff>1</falloff></spot>"
      "</light>");
  EXPECT_THAT(odd(),
              Contains(AllOf(HasSubstr("light inside | light lamp: at [1.00, 2.00, 3.20] it is "
                                       "inside of 'crate'"))));
}

TEST_F(RunCheckTest, ScenesCloserTogetherThanTheRecordingAreNamed) {
  record([](double t) { return poseAt(0.0, -0.5 + t, 0.0); });
  parameters["simulated_rate"] = Value(200.0);
  EXPECT_THAT(odd(), Contains(AllOf(HasSubstr("too dense | simulated_rate: makes 200 Hz of a "
                                              "recording whose frames move at 20 Hz at most"),
                                    HasSubstr("`simulated_rate: 20` or less"))));
}

TEST_F(RunCheckTest, WhatNeverMovesIsNamed) {
  record([](double) { return poseAt(0.0, -0.5, 0.0); });
  EXPECT_THAT(odd(), Contains(HasSubstr("never moves | alpha: its frame 'alpha/base_link' is "
                                        "recorded, and does not move in the 0.8 s of the run")));
}

TEST_F(RunCheckTest, AStaticFrameBesideOneThatMovesIsNamed) {
  test::BagBuilder bag(run.folder() / "tiny.bag");
  bag.fix("map", "alpha/odom", milliseconds(1000), poseAt(0.0, -0.5, 0.0));
  bag.fix("map", "bravo/base_link", milliseconds(1000), poseAt(0.0, 1.0, 0.0));
  for (int i = 0; i <= 20; ++i) {
    bag.move("alpha/odom", "alpha/base_link", milliseconds(1000 + 50 * i),
             poseAt(0.0, 0.05 * i, 0.0));
  }
  bag.close();
  (*parameters.at("alpha").as<Value::Map>())["frame_id"] = Value("odom");
  EXPECT_THAT(odd(), Contains(AllOf(HasSubstr("never moves | alpha: its frame 'alpha/odom' is "
                                              "static, and does not move"),
                                    HasSubstr("while alpha/base_link does; `frame: "
                                              "alpha/base_link`"))));
}

TEST_F(RunCheckTest, ScenesThatAreEqualAreNamed) {
  test::BagBuilder bag(run.folder() / "tiny.bag");
  bag.fix("map", "alpha/base_link", milliseconds(1000), poseAt(0.0, -0.5, 0.0));
  bag.fix("map", "bravo/base_link", milliseconds(1000), poseAt(0.0, 1.0, 0.0));
  bag.move("map", "other", milliseconds(1000)).move("map", "other", milliseconds(2000));
  bag.close();
  EXPECT_THAT(odd(), Contains(HasSubstr("equal scenes | scenes: in 100 % of the scenes neither an "
                                        "object nor a camera has moved")));
}

TEST_F(RunCheckTest, ACameraThatFindsNoViewOfAnObjectInAWallIsNamed) {
  addCrate("0 0 0.5 0 0 0", "0.8 1.6 1.4");
  camera().erase("pose");
  camera()["sample"] = Value(Value::Map{
      {"look_at", Value("alpha")},
      {"distance", Value(Value::Map{{"uniform", Value(Value::List{Value(1.5), Value(3.0)})}})}});
  EXPECT_THAT(warnings(), Contains(AllOf(HasSubstr("camera/sample: something hides what the camera "
                                                   "looks at from all positions"),
                                         HasSubstr("would not have seen what they look at"))));
}

TEST_F(RunCheckTest, ADatasetOfOtherSettingsInTheFolderIsFoundAndStays) {
  (void)generate();
  EXPECT_THAT(odd(), IsEmpty()) << "a run with the same settings goes on with it";
  parameters["simulated_rate"] = Value(2.0);
  EXPECT_THAT(odd(), ElementsAre(AllOf(
                         StartsWith("earlier dataset | output_folder: '" + folder +
                                    "' holds a complete dataset of 4 scenes of other settings ("
                                    "simulated_rate: then "),
                         HasSubstr("; choose another folder, or set `if_exists: overwrite`"))));
  EXPECT_THAT(errors(), Contains(HasSubstr("simulated_rate"))) << "as the run is refused";
  parameters["if_exists"] = Value("overwrite");
  EXPECT_THAT(odd(), IsEmpty());
  EXPECT_TRUE(std::filesystem::exists(folder + "/manifest.sqlite"));
}

TEST_F(RunCheckTest, AManifestThatCannotBeReadIsFound) {
  std::filesystem::create_directories(folder);
  run.folder().write("out/manifest.sqlite", "no manifest");
  EXPECT_THAT(odd(), ElementsAre(AllOf(HasSubstr("output_folder: the manifest '" + folder),
                                       HasSubstr("cannot be read"),
                                       HasSubstr("remove it together with its dataset"))));
}

TEST_F(RunCheckTest, ADatasetThatMustNotBeTouchedIsFound) {
  (void)generate();
  parameters["if_exists"] = Value("error");
  EXPECT_THAT(odd(), ElementsAre(HasSubstr("holds a complete dataset of 4 scenes, and `if_exists: "
                                           "error`; choose another folder")));
}

TEST_F(RunCheckTest, WhatIsCheapIsWarnedOfInEveryRun) {
  record([](double) { return poseAt(0.0, -0.5, 0.0); });
  look(vector(-16.0, 0.5, 1.0));
  parameters["writers"] = Value(Value::List{
      Value(Value::Map{{"name", Value("coco")}, {"type", Value("synthetic_dataset/Coco")}})});
  WarningList reporter;
  (void)generate(reporter);
  EXPECT_THAT(reporter.messages, Contains(HasSubstr("alpha: its frame 'alpha/base_link' is "
                                                    "recorded, and does not move")));
  EXPECT_THAT(reporter.messages, Contains(HasSubstr("labels have fewer than 25 visible pixels")));
}

TEST_F(RunCheckTest, AFolderThatCannotBeMadeIsAnError) {
  parameters["output_folder"] = Value((run.folder() / "tiny.world").string());
  EXPECT_THAT(test::messagesOf([&] { (void)check(); }),
              Contains(HasSubstr("output_folder: cannot make the folder")));
}

TEST(CheckFigures, NameADiskAndAMemoryThatAreTooSmall) {
  RunFigures figures;
  figures.bytes = 9'000'000'000;
  figures.free_disk = 2'000'000'000;
  figures.memory = 64'000'000'000;
  figures.memory_limit = 16'000'000'000;
  const std::vector<Finding> findings = checkFigures(figures);
  ASSERT_THAT(findings, SizeIs(2));
  EXPECT_THAT(findings[0].message(), HasSubstr("about 9.0 GB, and 2.0 GB are free"));
  EXPECT_THAT(findings[1].message(),
              HasSubstr("about 64.0 GB of memory, and 16.0 GB are available"));
  figures.free_disk = std::nullopt;
  figures.memory = 0;
  EXPECT_THAT(checkFigures(figures), IsEmpty());
}

/// The bundled examples.
class ExampleCheck : public ::testing::TestWithParam<const char*> {};

TEST_P(ExampleCheck, FindsNothingOdd) {
  test::preparePluginEnvironment();
  const std::string file = test::sourceFolder() + "/config/" + GetParam();
  const Value settings =
      config::loadSettings(file, [](const std::string&) { return test::sourceFolder(); });
  Reporter silent;
  std::vector<std::string> lines;
  for (const Finding& each : checkRun(settings, silent, {test::pluginXml()}).findings) {
    lines.push_back(each.message());
  }
  EXPECT_THAT(lines, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(RunCheck, ExampleCheck,
                         ::testing::Values("example.yaml", "example_placement.yaml",
                                           "example_motions.yaml"));

}  // namespace run_check_test
}  // namespace synthetic_dataset::run

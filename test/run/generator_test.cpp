#include "run/generator.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include "all_at_once_run.h"
#include "base/yaml_value.h"
#include "run_fixture.h"
#include "support/bag_builder.h"
#include "support/tiny_run.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::run {
namespace generator_test {

namespace fs = std::filesystem;
using test::StoppingReporter;
using test::TinyRun;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

using GeneratorTest = test::RunFixture;

TEST_F(GeneratorTest, MakesTheThreeDatasetsOfTheOriginal) {
  const RunSummary summary = generate();
  EXPECT_EQ(summary.scenes, 4);
  const auto made = files();
  for (const std::string number : {"00000000", "00000003"}) {
    EXPECT_TRUE(made.count("yolo/" + number + ".png"));
    EXPECT_THAT(made.at("yolo/" + number + ".txt"), HasSubstr("box 0."));
    EXPECT_THAT(made.at("bounding_shape/" + number + ".txt"), HasSubstr("bravo -0.20000 0.80000"));
    for (const std::string object : {"alpha", "bravo"}) {
      EXPECT_TRUE(made.count("stvnet/" + object + "/JPEGImages/" + number + ".png"));
      EXPECT_TRUE(made.count("stvnet/" + object + "/mask/" + number + ".png"));
      EXPECT_THAT(made.at("stvnet/" + object + "/labels/" + number + ".txt"),
                  HasSubstr(object + " 0."));
    }
  }
  EXPECT_EQ(made.count("yolo/00000004.png"), 0U);
  EXPECT_THAT(made.at("yolo/list.txt"), HasSubstr("/out/yolo/00000000.png\n"));
}

struct StageListener : Reporter {
  void stage(const std::string& what) override { stages.push_back(what); }
  std::vector<std::string> stages;
};

TEST_F(GeneratorTest, NamesTheStagesOfItsStart) {
  StageListener listener;
  generate(listener);
  const auto at = [&](const std::string& part) {
    const auto found = std::find_if(
        listener.stages.begin(), listener.stages.end(),
        [&](const std::string& stage) { return stage.find(part) != std::string::npos; });
    EXPECT_NE(found, listener.stages.end()) << part;
    return found;
  };
  EXPECT_LT(at("reading the recording '"), at(".world'"));
  EXPECT_LT(at(".world'"), at("reading the objects' models"));
  EXPECT_LT(at("reading the objects' models"), at("preparing the writers"));
  EXPECT_LT(at("preparing the writers"), at("giving the world to OpenGL"));
  EXPECT_EQ(listener.stages.back(), "drawing the first scene");
}

TEST_F(GeneratorTest, SeesTheObjectsWhereTheLabelsSay) {
  generate();
  const cv::Mat image = cv::imread((run.folder() / "out/yolo/00000000.png").string());
  const cv::Mat mask = cv::imread((run.folder() / "out/stvnet/bravo/mask/00000000.png").string(),
                                  cv::IMREAD_GRAYSCALE);
  ASSERT_EQ(image.size(), cv::Size(160, 120));
  // bravo, at y = 1 and 3 m away (its front at 2.8 m), is left of the middle and blue.
  const cv::Point bravo(static_cast<int>(79.5 - 0.8 * 140 / 2.8),
                        static_cast<int>(59.5 + 0.3 * 50));
  const cv::Vec3b colour = image.at<cv::Vec3b>(bravo);
  EXPECT_GT(colour[0], colour[2] + 50);
  EXPECT_EQ(mask.at<unsigned char>(bravo), 255);
  EXPECT_EQ(mask.at<unsigned char>(0, 0), 0);
}

TEST_F(GeneratorTest, TwoRunsGiveTheSameBytes) {
  generate();
  const auto first = files();
  parameters["if_exists"] = Value("overwrite");
  generate();
  EXPECT_TRUE(first == files());
  EXPECT_GT(first.size(), 20U);
}

TEST_F(GeneratorTest, AllFormatsGiveTheSameBytesTwice) {
  const std::vector<std::pair<std::string, Value::Map>> formats = {
      {"Bop", {}},
      {"Cityscapes", {}},
      {"Coco", {{"panoptic", Value(true)}}},
      {"Dope", {}},
      {"ImageFolder",
       {{"webdataset", Value(true)},
        {"depth", Value(true)},
        {"normals", Value(true)},
        {"optical_flow", Value(true)}}},
      {"Kitti", {}},
      {"PascalVoc", {}},
      {"PvNet", {}},
      {"RosBag", {}},
      {"StvNet", {}},
      {"UltralyticsYolo", {{"task", Value("segment")}}}};
  Value::List writers;
  for (const auto& [type, settings] : formats) {
    writers.emplace_back(
        Value::Map{{"name", Value("w_" + type)}, {"type", Value("synthetic_dataset/" + type)}});
    parameters["w_" + type] = Value(settings);
  }
  parameters["writers"] = Value(writers);
  parameters["split"] = Value(Value::Map{{"train", Value(0.5)}, {"val", Value(0.5)}});
  parameters.erase("yolo");
  parameters.erase("bounding_shape");
  generate();
  const auto first = files();
  parameters["if_exists"] = Value("overwrite");
  generate();
  EXPECT_TRUE(first == files());
  EXPECT_GT(first.size(), 150U);
}

TEST_F(GeneratorTest, RefusesToTouchADatasetThatIsThere) {
  generate();
  const auto first = files();
  parameters["if_exists"] = Value("error");
  EXPECT_THAT(errors(), Contains(HasSubstr("overwrite")));
  EXPECT_TRUE(first == files());
}

TEST_F(GeneratorTest, ComputesNoMasksWhenNoWriterAsks) {
  parameters["writers"] = Value(Value::List{
      Value(Value::Map{{"name", Value("yolo")}, {"type", Value("synthetic_dataset/Yolo")}})});
  parameters.erase("bounding_shape");
  EXPECT_EQ(generate().files, 4 * 2 + 1 + 3);  // Darknet's names, data and list
}

TEST_F(GeneratorTest, LeavesOutAndCountsScenesAcrossGaps) {
  parameters["max_tf_gap"] = Value(0.03);  // alpha's transforms are 0.05 s apart
  parameters["simulated_rate"] = Value(1000.0 / 125.0);
  const RunSummary summary = generate();
  // Every second scene falls on a transform, and needs no interpolation.
  EXPECT_EQ(summary.scenes, 4);
  EXPECT_EQ(
      summary.warnings.at("scene left out: TF would be interpolated across more than max_tf_gap"),
      4);
}

TEST_F(GeneratorTest, ReportsObjectsThatAreInsideOneAnotherOnceAPair) {
  test::BagBuilder bag(run.folder() / "tiny.bag");
  bag.fix("map", "bravo/base_link", test::milliseconds(1000), test::poseAt(0, 0.1, 0));
  bag.fix("map", "alpha/base_link", test::milliseconds(1000), test::poseAt(0, 0, 0));
  bag.say("/other", test::milliseconds(1000)).say("/other", test::milliseconds(2000)).close();
  const RunSummary summary = generate();
  EXPECT_EQ(summary.warnings.at("'alpha' and 'bravo' are inside one another"), summary.scenes);
}

TEST_F(GeneratorTest, StopsBetweenScenesWhenAsked) {
  StoppingReporter impatient(2);
  parameters["simulated_rate"] = Value(40.0);
  Generator generator(Value(parameters), impatient, {test::pluginXml()});
  const RunSummary summary = generator.run();
  EXPECT_TRUE(summary.stopped);
  // Scenes that are being written at that time are finished.
  EXPECT_GE(summary.scenes, 2);
  EXPECT_LT(summary.scenes, summary.planned_scenes);
  EXPECT_EQ(summary.dataset_scenes, summary.scenes);
  EXPECT_EQ(files().count("yolo/list.txt"), 0U);
}

// --- Bad input: each with its message ---

TEST_F(GeneratorTest, NamesACalibrationThatIsMissingBesideAWorldThatIs) {
  parameters["world"] = Value((run.folder() / "gone.world").string());
  (*parameters.at("camera").as<Value::Map>())["info_file"] =
      Value((run.folder() / "gone.yaml").string());
  EXPECT_THAT(errors(), AllOf(Contains(HasSubstr("gone.world")), Contains(HasSubstr("gone.yaml"))));
  parameters["bag_file"] = Value((run.folder() / "gone.bag").string());
  EXPECT_THAT(errors(), AllOf(Contains(HasSubstr("gone.bag")), Contains(HasSubstr("gone.yaml"))));
}

TEST_F(GeneratorTest, NamesAWrongPoseOnce) {
  (*parameters.at("camera").as<Value::Map>())["pose"] = Value(Value::List{Value(1.0), Value(2.0)});
  EXPECT_THAT(errors(), ElementsAre(HasSubstr("camera/pose: found 2 numbers")));
}

TEST_F(GeneratorTest, NamesAModelThatIsMissingByItsSettingOnce) {
  for (const char* name : {"alpha", "bravo"}) {
    (*parameters.at(name).as<Value::Map>())["model"] = Value("/nowhere/rover.sdf");
  }
  EXPECT_THAT(errors(), ElementsAre("alpha/model: '/nowhere/rover.sdf': no such file"));
}

TEST_F(GeneratorTest, KnowsFilesThatAreSpeltNearlyAlike) {
  parameters["bag_file"] = Value((run.folder() / "tniy.bag").string());
  parameters["world"] = Value((run.folder() / "tinny.world").string());
  EXPECT_THAT(errors(), testing::UnorderedElementsAre(HasSubstr("did you mean 'tiny.bag'?"),
                                                      HasSubstr("did you mean 'tiny.world'?")));
}

TEST_F(GeneratorTest, SaysWhereRelativePathsStart) {
  parameters["bag_file"] = Value("recordings/gone.bag");
  EXPECT_THAT(errors(),
              ElementsAre(AllOf(HasSubstr("gone.bag: no such file"),
                                HasSubstr("'recordings/gone.bag' is relative to the current "
                                          "folder: \"$(dirname)/recordings/gone.bag\""))));
}

TEST_F(GeneratorTest, NamesAVariableOfAShellAsSettingsHaveIt) {
  parameters["bag_file"] = Value("$HOME/gone.bag");
  EXPECT_THAT(errors(), ElementsAre(HasSubstr("gone.bag: no such file; in settings, $(env HOME) is "
                                              "what a shell calls $HOME")));
}

TEST_F(GeneratorTest, NamesWhatIsCompressedOrNoText) {
  const auto write = [&](const std::string& name, const std::string& bytes) {
    return Value(run.folder().write(name, bytes).string());
  };
  parameters["world"] = write("hall.world.gz", "\x1f\x8b\x08 and more");
  parameters["bag_file"] = write("a.bag.bz2", "BZh91AY&SY and more");
  (*parameters.at("camera").as<Value::Map>())["info_file"] =
      write("a.png", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR:\t[", 20));
  EXPECT_THAT(errors(), AllOf(Contains(HasSubstr("a.bag.bz2: is compressed; `bunzip2` unpacks it")),
                              Contains(HasSubstr("a.png: line 1: is not a text file"))));
  parameters["bag_file"] = Value((run.folder() / "tiny.bag").string());
  EXPECT_THAT(errors(), Contains(HasSubstr("hall.world.gz: is compressed; `gunzip` unpacks it")));
}

TEST_F(GeneratorTest, NamesTheObjectsThatACameraMayLookAt) {
  Value::Map& camera = *parameters.at("camera").as<Value::Map>();
  camera["pose"] =
      Value(Value::Map{{"position", Value(Value::List{Value(-3.0), Value(0.2), Value(0.5)})},
                       {"look_at", Value("husky")}});
  EXPECT_THAT(errors(), ElementsAre(HasSubstr("camera/pose/look_at: found 'husky'; it should be an "
                                              "object of robot_list (alpha, bravo) or a point")));
}

TEST_F(GeneratorTest, PassesOverTheSettingsOfFormatsThatWritersDoesNotName) {
  parameters["writers"] = Value(Value::List{
      Value(Value::Map{{"name", Value("labels")}, {"type", Value("synthetic_dataset/Coco")}})});
  parameters["pascal_voc"] = Value(Value::Map{{"layout", Value("flat")}});
  struct Notes : Reporter {
    void info(const std::string& message) override { messages.push_back(message); }
    std::vector<std::string> messages;
  } reporter;
  (void)generate(reporter);
  EXPECT_THAT(reporter.messages,
              AllOf(Contains("yolo: its settings are not used, as `writers` does not name it"),
                    Contains(HasSubstr("bounding_shape: its settings are not used")),
                    Contains(HasSubstr("pascal_voc: its settings are not used"))));
  parameters["yollo"] = Value(Value::Map{{"main_list", Value("list.txt")}});
  EXPECT_THAT(errors(), Contains(HasSubstr("yollo: unknown parameter")));
}

TEST_F(GeneratorTest, NamesABagThatIsMissing) {
  parameters["bag_file"] = Value("/nowhere/a.bag");
  EXPECT_THAT(errors(), Contains(AllOf(HasSubstr("/nowhere/a.bag"), HasSubstr("no such file"))));
}

TEST_F(GeneratorTest, NamesAFileThatIsNoBag) {
  parameters["bag_file"] = Value(run.folder().write("not.bag", "hello").string());
  EXPECT_THAT(errors(), Contains(HasSubstr("not.bag")));
}

TEST_F(GeneratorTest, NamesATruncatedBagAndWhatMendsIt) {
  const std::string whole = test::readFile(run.folder() / "tiny.bag");
  parameters["bag_file"] = Value(run.folder().write("cut.bag", whole.substr(0, 5000)).string());
  EXPECT_THAT(errors(), Contains(AllOf(HasSubstr("cut.bag"), HasSubstr("rosbag reindex"))));
}

TEST_F(GeneratorTest, NamesABagWithoutTransforms) {
  test::BagBuilder bag(run.folder() / "talk.bag");
  parameters["bag_file"] = Value(bag.say("/chatter", test::milliseconds(1000)).close());
  EXPECT_THAT(errors(), Contains(AllOf(HasSubstr("talk.bag"), HasSubstr("/chatter"))));
}

TEST_F(GeneratorTest, SuggestsAFrameThatIsSpeltNearlyAlike) {
  parameters.at("alpha").as<Value::Map>()->emplace("frame_id", Value("base_lnik"));
  EXPECT_THAT(errors(),
              Contains(AllOf(testing::StartsWith("alpha/frame_id: frame 'alpha/base_lnik'"),
                             HasSubstr("alpha/base_link"))));
}

TEST_F(GeneratorTest, NamesTheSettingThatAWrongFrameCameFrom) {
  parameters.at("alpha").as<Value::Map>()->emplace("frame", Value("alpha/base_lnik"));
  EXPECT_THAT(errors(), Contains(testing::StartsWith("alpha/frame: frame 'alpha/base_lnik'")));
}

TEST_F(GeneratorTest, NamesAnObjectThatTheWorldDoesNotHave) {
  parameters["robot_list"] = Value("charlie");
  parameters["charlie"] = Value(TinyRun::object("charlie"));
  EXPECT_THAT(errors(), Contains(AllOf(HasSubstr("no model 'charlie'"), HasSubstr("alpha, bravo"),
                                       HasSubstr("charlie/model"))));
}

TEST_F(GeneratorTest, NamesAWriterThatDoesNotExist) {
  parameters["writers"] = Value(Value::List{
      Value(Value::Map{{"name", Value("yolo")}, {"type", Value("synthetic_dataset/Yollo")}})});
  EXPECT_THAT(errors(), Contains(AllOf(HasSubstr("synthetic_dataset/Yollo"),
                                       HasSubstr("synthetic_dataset/Yolo'"))));
}

TEST_F(GeneratorTest, RefusesTwoWritersInOneFolder) {
  (*parameters.at("yolo").as<Value::Map>())["output_folder"] =
      Value((run.folder() / "out/stvnet").string());
  EXPECT_THAT(errors(), Contains(AllOf(HasSubstr("yolo"), HasSubstr("stvnet"))));
}

TEST_F(GeneratorTest, NamesAFolderThatCannotBeMade) {
  run.folder().write("file", "in the way");
  parameters["output_folder"] = Value((run.folder() / "file/out").string());
  EXPECT_THAT(errors(), Contains(HasSubstr("file/out")));
}

TEST_F(GeneratorTest, NamesAMeshThatIsMissing) {
  std::string world = test::readFile(run.folder() / "tiny.world");
  const std::string box = "<geometry><sphere><radius>0.1</radius></sphere></geometry></visual>";
  world.replace(world.find(box), box.size(),
                "<geometry><mesh><uri>model://ball/ball.dae</uri></mesh></geometry></visual>");
  run.folder().write("tiny.world", world);
  EXPECT_THAT(errors(), Contains(AllOf(HasSubstr("tiny.world"), HasSubstr("'ball'"),
                                       HasSubstr("model://ball/ball.dae"))));
}

TEST_F(GeneratorTest, NamesAWorldThatDoesNotParse) {
  run.folder().write("tiny.world", "<sdf version='1.6'><world name='broken'>");
  EXPECT_THAT(errors(), Contains(HasSubstr("tiny.world")));
}

TEST_F(GeneratorTest, NamesARateOfZero) {
  parameters["simulated_rate"] = Value(0);
  EXPECT_THAT(errors(), Contains("simulated_rate: found 0.0; it should be above 0.0"));
}

TEST_F(GeneratorTest, TellsOfAPoseThatIsNoNumber) {
  test::BagBuilder bag(run.folder() / "nan.bag");
  bag.fix("map", "bravo/base_link", test::milliseconds(1000), test::poseAt(0, 1, 0));
  for (int i = 0; i <= 20; ++i) {
    test::BagBuilder::Transform transform;
    transform.parent = "map";
    transform.child = "alpha/base_link";
    transform.stamp = transform.recorded = test::milliseconds(1000 + 50 * i);
    transform.x = i == 7 ? NAN : 0.1;
    bag.add(transform);
  }
  parameters["bag_file"] = Value(bag.close());
  const RunSummary summary = generate();
  EXPECT_EQ(summary.scenes, 4) << "tf2 interpolates over the transform that is left out";
  EXPECT_THAT(summary.warnings,
              Contains(testing::Key(AllOf(HasSubstr("alpha/base_link"), HasSubstr("NaN")))));
}

TEST_F(GeneratorTest, NamesAFrameThatOnlyAWriterAsksFor) {
  (*parameters.at("bounding_shape").as<Value::Map>())["output_frame"] = Value("alpha/base_lnik");
  EXPECT_THAT(errors(),
              Contains(AllOf(HasSubstr("alpha/base_lnik"), HasSubstr("alpha/base_link"))));
}

TEST_F(GeneratorTest, TellsWritersOfTheScenesThatHaveTheirFramesAlone) {
  test::BagBuilder bag(run.folder() / "late.bag");
  bag.fix("map", "bravo/base_link", test::milliseconds(1000), test::poseAt(0, 1, 0));
  for (int i = 0; i <= 20; ++i) {
    bag.move("map", "alpha/base_link", test::milliseconds(1000 + 50 * i), test::poseAt(0.1, 0, 0));
    if (i <= 10) bag.move("map", "tool", test::milliseconds(1000 + 50 * i));
  }
  parameters["bag_file"] = Value(bag.close());
  parameters["split"] = Value(Value::Map{{"train", Value(0.85)}, {"val", Value(0.15)}});
  (*parameters.at("bounding_shape").as<Value::Map>())["output_frame"] = Value("tool");
  parameters.erase("yolo");
  parameters["writers"] = base::parseYaml(
      "[{name: folder, type: synthetic_dataset/ImageFolder},"
      " {name: bounding_shape, type: synthetic_dataset/BoundingShape}]",
      "test");
  EXPECT_EQ(generate().scenes, 3) << "the tool is known for half of the recording";
  const std::string card = files().at("folder/README.md");
  EXPECT_THAT(card, AllOf(HasSubstr("split: train"), Not(HasSubstr("split: val"))))
      << "of four scenes the last would be one to validate with";
  parameters["only_scenes"] = Value(Value::List{Value(3)});
  EXPECT_THAT(errors(), Contains("only_scenes: found 3; this run's scenes are 0 to 2"));
}

TEST_F(GeneratorTest, FindsAllErrorsAtOnceAndLeavesTheDiskAlone) {
  parameters["bag_file"] = Value("/nowhere/a.bag");
  parameters["world"] = Value("/nowhere/b.world");
  parameters["simulated_rte"] = Value(3);
  parameters.erase("yolo");
  const auto messages = errors();
  EXPECT_THAT(messages, Contains(HasSubstr("/nowhere/a.bag")));
  EXPECT_THAT(messages, Contains(HasSubstr("/nowhere/b.world")));
  EXPECT_THAT(messages, Contains(HasSubstr("did you mean 'simulated_rate'")));
  EXPECT_THAT(messages, Contains("yolo/main_list: required, but missing"));
  EXPECT_FALSE(fs::exists(run.folder() / "out"));
}

/// Records a bag in which alpha is there only for a quarter of a second.
void letAlphaComeAndGo(const TinyRun& run) {
  test::BagBuilder bag(run.folder() / "tiny.bag");
  bag.fix("map", "bravo/base_link", test::milliseconds(1000), test::poseAt(0, 1, 0));
  for (int i = 0; i <= 5; ++i) {
    bag.move("map", "alpha/base_link", test::milliseconds(1450 + 50 * i),
             test::poseAt(0, 0.05 * i, 0));
  }
  bag.say("/other", test::milliseconds(1000)).say("/other", test::milliseconds(2000)).close();
}

TEST_F(GeneratorTest, SaysWhichObjectCostsMostOfTheRecording) {
  letAlphaComeAndGo(run);
  parameters["simulated_rate"] = Value(8.0);
  const RunSummary summary = generate();
  EXPECT_EQ(summary.scenes, 1);
  std::vector<std::string> warnings;
  for (const auto& [warning, count] : summary.warnings) warnings.push_back(warning);
  EXPECT_THAT(warnings, Contains(AllOf(HasSubstr("alpha: no scenes in 0.8 s of the "
                                                 "recording's 1.0 s"),
                                       HasSubstr("TF has 'alpha/base_link' in 'map' from 1.45"),
                                       HasSubstr("`when_unknown: absent` in the group alpha"))));
}

TEST_F(GeneratorTest, MakesScenesWithoutAnObjectThatMayBeAbsent) {
  letAlphaComeAndGo(run);
  parameters["simulated_rate"] = Value(8.0);
  (*parameters.at("alpha").as<Value::Map>())["when_unknown"] = Value("absent");
  EXPECT_EQ(generate().scenes, 8);
  const auto labels = files();
  EXPECT_EQ(labels.at("yolo/00000000.txt").find("alpha"), std::string::npos);
  const cv::Mat without = cv::imread(folder + "/yolo/00000000.png");
  const cv::Mat with = cv::imread(folder + "/yolo/00000004.png");
  ASSERT_FALSE(without.empty() || with.empty());
  EXPECT_GT(cv::norm(without, with, cv::NORM_INF), 50.0) << "alpha is in one of them alone";
}

TEST_F(GeneratorTest, PassesOverStrangeNamesInAFileOfTheOriginal) {
  parameters["cmd_vel_topic"] = Value("/cmd_vel");
  EXPECT_THAT(errors(), ElementsAre(HasSubstr("cmd_vel_topic: unknown parameter")));
  (*parameters.at("yolo").as<Value::Map>())["output_folder"] = Value(folder + "/labels");
  std::vector<std::string> warnings;
  for (const auto& [warning, count] : generate().warnings) warnings.push_back(warning);
  EXPECT_THAT(warnings, Contains(AllOf(HasSubstr("cmd_vel_topic: unknown parameter"),
                                       HasSubstr("it is ignored"))));
}

}  // namespace generator_test
}  // namespace synthetic_dataset::run

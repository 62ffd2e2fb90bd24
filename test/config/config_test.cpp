#include "config/config.h"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <chrono>

#include "base/yaml_value.h"

namespace synthetic_dataset::config {
namespace config_test {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

constexpr char kMinimal[] = R"(
bag_file: /data/run.bag
world: /data/hall.world
camera: {info_file: /data/camera.yaml, pose: [0, 0, 2, 0, 0, 0, 1]}
robot_list: alpha
output_folder: /out
yolo: {main_list: /out/list.txt}
bounding_shape: {output_frame: map}
alpha:
  class: summit
  id: 7
  keypoints: []
  bounding_shape: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
)";

/// The parameters and configuration of a settings text: the minimal file, in which with() replaces
/// a text and to which plus() adds lines.
struct Reading {
  explicit Reading(const std::string& text) : root(base::parseYaml(text, "test")) {
    config = readConfig(root);
  }
  Parameters root;
  Config config;
};

std::string with(const std::string& old_text, const std::string& new_text) {
  std::string text = kMinimal;
  return text.replace(text.find(old_text), old_text.size(), new_text);
}

std::string plus(const std::string& lines) { return kMinimal + lines; }

TEST(ReadConfig, AMinimalFileTakesTheOriginalsDefaults) {
  const Reading reading(kMinimal);
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  const Config& config = reading.config;
  EXPECT_EQ(config.motion.rate, 30.0);
  EXPECT_EQ(config.global_frame, "map");
  EXPECT_EQ(config.cameras.at(0).frame, "camera/optical_link");
  EXPECT_EQ(config.masks.mog2.history_length, 100);
  EXPECT_EQ(config.masks.mog2.var_threshold, 500.0);
  EXPECT_FALSE(config.masks.mog2.detect_shadows);
  ASSERT_EQ(config.objects.size(), 1U);
  EXPECT_EQ(config.objects[0].frame, "alpha/base_link");
  EXPECT_EQ(config.objects[0].class_name, "summit");
  EXPECT_EQ(config.objects[0].id, "7");
  EXPECT_THAT(reading.root.defaultsTaken(), Contains("simulated_rate: 30.0"));
}

TEST(ReadConfig, LabelsHaveTheTextThatPythonPrints) {
  // nn_data_collection wrote str() of what YAML gave it.
  for (const auto& [given, text] : {std::pair("true", "True"), std::pair("2.50", "2.5"),
                                    std::pair("010", "8"), std::pair("'007'", "007")}) {
    const Reading reading(with("class: summit", std::string("class: ") + given));
    EXPECT_THAT(reading.root.errors(), IsEmpty());
    EXPECT_EQ(reading.config.objects.at(0).class_text, text);
  }
}

TEST(ReadConfig, LeftOutWritersAreTheOriginalsThree) {
  const Config config = Reading(kMinimal).config;
  ASSERT_EQ(config.writers.size(), 3U);
  EXPECT_EQ(config.writers[0].name, "bounding_shape");
  EXPECT_EQ(config.writers[1].type, "synthetic_dataset/Yolo");
  EXPECT_EQ(config.writers[2].output_folder, "/out/stvnet/");
}

TEST(ReadConfig, WithoutWritersAndTheOriginalsGroupsALineIsAskedFor) {
  std::string text = with("yolo: {main_list: /out/list.txt}\n", "");
  const std::string shape = "bounding_shape: {output_frame: map}\n";
  text.erase(text.find(shape), shape.size());
  const Reading reading(text);
  EXPECT_THAT(reading.root.errors(),
              ElementsAre(AllOf(HasSubstr("writers: missing"),
                                HasSubstr("[{name: coco, type: synthetic_dataset/Coco}]"))));
}

TEST(ReadConfig, WritersMayShareATypeUnderTwoNames) {
  const Reading reading(plus("writers: [{name: a, type: p/Yolo}, {name: b, type: p/Yolo}]\n"));
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  ASSERT_EQ(reading.config.writers.size(), 2U);
  EXPECT_EQ(reading.config.writers[1].output_folder, "/out/b/");
}

TEST(ReadConfig, WithoutAnOutputFolderTheManifestLiesAboveTheWriters) {
  const Reading reading(
      with("output_folder: /out\nyolo: {main_list: /out/list.txt}\nbounding_shape: {output_frame: "
           "map}",
           "yolo: {main_list: /out/list.txt, output_folder: /out/yolo/data}\n"
           "stvnet: {output_folder: /out/stvnet}\n"
           "bounding_shape: {output_frame: map, output_folder: /out/bounding_shape}"));
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  EXPECT_EQ(reading.config.output.folder, "/out");
  EXPECT_EQ(reading.config.writers[1].output_folder, "/out/yolo/data/");
}

TEST(ReadConfig, AllMissingParametersAreNamedAtOnce) {
  const Reading reading("alpha: {}\nrobot_list: [alpha]\n");
  EXPECT_THAT(
      reading.root.errors(),
      UnorderedElementsAre("bag_file: required, but missing", "world: required, but missing",
                           HasSubstr("camera: no intrinsics"), "alpha/class: required, but missing",
                           "alpha/id: required, but missing", HasSubstr("writers: missing")));
}

TEST(ReadConfig, TopicsMayBeNamedWithWhatTheyMove) {
  const Reading reading(plus(
      "tf_topics: /robot1/tf\n"
      "pose_topics: [/odom, {topic: /vicon/cup, frame: cup}, {topic: /joints, object: arm}]\n"));
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  EXPECT_THAT(reading.config.motion.tf_topics, ElementsAre("/robot1/tf"));
  const auto& topics = reading.config.motion.pose_topics;
  ASSERT_EQ(topics.size(), 3U);
  EXPECT_EQ(topics[0].topic, "/odom");
  EXPECT_EQ(topics[1].frame, "cup");
  EXPECT_EQ(topics[2].object, "arm");
}

TEST(ReadConfig, AHoleMayBeOfAnyLength) {
  const Reading reading(plus("max_tf_gap: .inf\nstretch: 2\n"));
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  EXPECT_TRUE(std::isinf(*reading.config.motion.max_tf_gap));
  EXPECT_EQ(reading.config.motion.stretch, 2U);
}

TEST(ReadConfig, WorldMayBeAGroup) {
  const Config config =
      Reading(with("world: /data/hall.world",
                   "world: {file: /data/hall.world, model_folders: [/models, /more]}"))
          .config;
  EXPECT_EQ(config.world.file, "/data/hall.world");
  EXPECT_THAT(config.world.model_folders, ElementsAre("/models", "/more"));
}

TEST(ReadConfig, SaysWhatMissingAssetsMean) {
  const auto reading = [](const std::string& rest) {
    return Reading(with("world: /data/hall.world", "world: {file: /data/hall.world" + rest + "}"));
  };
  EXPECT_EQ(reading("").config.world.loading.on_missing_asset, world::OnMissingAsset::kError);
  EXPECT_EQ(reading(", on_missing_asset: warn").config.world.loading.on_missing_asset,
            world::OnMissingAsset::kWarn);
  EXPECT_THAT(reading(", on_missing_asset: ignore").root.errors(),
              ElementsAre("world/on_missing_asset: found 'ignore'; it should be error or warn"));
}

TEST(ReadConfig, SaysWhichSimulatorTheWorldIsFor) {
  const auto reading = [](const std::string& rest) {
    return Reading(with("world: /data/hall.world", "world: {file: /data/hall.world" + rest + "}"));
  };
  EXPECT_EQ(reading("").config.world.loading.simulator, std::nullopt);
  EXPECT_EQ(reading(", simulator: auto").config.world.loading.simulator, std::nullopt);
  EXPECT_EQ(reading(", simulator: classic").config.world.loading.simulator,
            world::Simulator::kClassic);
  EXPECT_EQ(reading(", simulator: gz").config.world.loading.simulator, world::Simulator::kGz);
  EXPECT_THAT(reading(", simulator: ogre").root.errors(),
              ElementsAre("world/simulator: found 'ogre'; it should be auto, classic or gz"));
}

TEST(ReadConfig, WorldFileReplacesTheWorldsFileAlone) {
  const Reading reading(with("world: /data/hall.world",
                             "world: {file: /data/hall.world, model_folders: [/models]}\n"
                             "world_file: /data/yard.world"));
  EXPECT_EQ(reading.config.world.file, "/data/yard.world");
  EXPECT_THAT(reading.config.world.model_folders, ElementsAre("/models"));
  EXPECT_THAT(Reading(with("world: /data/hall.world", "world_file: /a.world")).root.errors(),
              IsEmpty());
}

TEST(ReadConfig, WithoutABoundingShapeTheModelsBoxIsTaken) {
  const std::string given = "  bounding_shape: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]\n";
  for (const std::string text : {"", "  bounding_shape: model_box\n"}) {
    const Reading reading(with(given, text));
    EXPECT_THAT(reading.root.errors(), IsEmpty());
    EXPECT_THAT(reading.config.objects[0].bounding_shape_O, IsEmpty());
  }
  EXPECT_THAT(Reading(with(given, "")).root.defaultsTaken(),
              Contains("alpha/bounding_shape: model_box"));
}

TEST(ReadConfig, KeypointsMayBeFarthestPoints) {
  for (const std::string text :
       {"keypoints: {farthest_points: 9}", "keypoints: 'farthest_points: 9'"}) {
    const Reading reading(with("keypoints: []", text));
    EXPECT_THAT(reading.root.errors(), IsEmpty());
    EXPECT_EQ(reading.config.objects[0].farthest_points, 9);
    EXPECT_THAT(unknownParameterErrors(reading.root, reading.root.unknownNames()),
                testing::Not(Contains(HasSubstr("farthest_points"))));
  }
  const Reading without(with("  keypoints: []\n", ""));
  EXPECT_THAT(without.root.errors(), IsEmpty());
  EXPECT_EQ(without.config.objects[0].farthest_points, 0);
}

TEST(ReadConfig, AFrameMayBeNamedWhole) {
  EXPECT_EQ(
      Reading(with("keypoints: []", "frame: base_link\n  keypoints: []")).config.objects[0].frame,
      "base_link");
}

TEST(ReadConfig, LinkFramesAreAPatternOrAMap) {
  EXPECT_EQ(Reading(kMinimal).config.objects[0].link_frames.pattern, "{object}/{link}");
  const Reading pattern(with("keypoints: []", "link_frames: 'tf_{link}'\n  keypoints: []"));
  EXPECT_THAT(pattern.root.errors(), IsEmpty());
  EXPECT_EQ(pattern.config.objects[0].link_frames.pattern, "tf_{link}");
  const Reading map(with("keypoints: []", "link_frames: {arm: a/arm}\n  keypoints: []"));
  EXPECT_THAT(map.root.errors(), IsEmpty());
  EXPECT_THAT(map.config.objects[0].link_frames.by_link,
              ElementsAre(testing::Pair("arm", "a/arm")));
}

TEST(ReadConfig, AXacroModelTakesArgumentsAsTexts) {
  const Reading reading(with("keypoints: []",
                             "model: /m/arm.urdf.xacro\n"
                             "  model_arguments: {prefix: left_, gripper: true, length: 0.5}\n"
                             "  keypoints: []"));
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  EXPECT_THAT(reading.config.objects[0].model_arguments,
              ElementsAre(testing::Pair("gripper", "true"), testing::Pair("length", "0.5"),
                          testing::Pair("prefix", "left_")));
}

TEST(ReadConfig, AModelMayBeAText) {
  const Reading reading(with("keypoints: []", "model: ' <robot name=\"r\"/>'\n  keypoints: []"));
  EXPECT_EQ(reading.config.objects[0].model, " <robot name=\"r\"/>");
}

constexpr char kPlaced[] = "motion: placement\nscenes: 5\nplacement: {map: /a.yaml}\n";

TEST(ReadConfig, FollowsABagUnlessObjectsArePlaced) {
  EXPECT_EQ(Reading(kMinimal).config.motion.source, motion::MotionSource::kBag);
  EXPECT_EQ(Reading(plus("motion: bag\n")).config.motion.source, motion::MotionSource::kBag);
  const Reading reading(with("bag_file: /data/run.bag\n", kPlaced));
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  EXPECT_EQ(reading.config.motion.source, motion::MotionSource::kPlacement);
  EXPECT_EQ(reading.config.motion.scenes, 5);
  EXPECT_EQ(reading.config.placement.map_file, "/a.yaml");
  EXPECT_THAT(reading.config.motion.bag_files, IsEmpty());
}

TEST(ReadConfig, PlacementMayHaveABagToo) {
  const Reading reading(plus(kPlaced));
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  EXPECT_THAT(reading.config.motion.bag_files, ElementsAre("/data/run.bag"));
}

TEST(ReadConfig, TakesABagForEachFileOfAPattern) {
  const std::string folder = ::testing::TempDir() + "bags_by_pattern";
  std::filesystem::create_directories(folder);
  for (const char* name : {"walk_2.bag", "walk_1.bag", "run.bag"}) {
    std::ofstream(folder + "/" + name).put('\n');
  }
  const Reading reading(with("bag_file: /data/run.bag\n",
                             "bag_file: [" + folder + "/walk_*.bag, " + folder + "/run.bag]\n"));
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  EXPECT_THAT(reading.config.motion.bag_files,
              ElementsAre(folder + "/walk_1.bag", folder + "/walk_2.bag", folder + "/run.bag"));
  const Reading none(with("bag_file: /data/run.bag\n", "bag_file: /nowhere/*.bag\n"));
  EXPECT_THAT(none.root.errors(),
              Contains(HasSubstr("bag_file: found no bag like '/nowhere/*.bag'")));
}

TEST(ReadConfig, PropsComeToRestBeforeObjectsArePlaced) {
  EXPECT_EQ(Reading(kMinimal).config.settling.count(), 0);
  EXPECT_EQ(Reading(plus(kPlaced)).config.settling, std::chrono::seconds(10));
  EXPECT_EQ(Reading(plus(std::string(kPlaced) + "physics: {settle: 2}")).config.settling,
            std::chrono::seconds(2));
}

TEST(ReadConfig, ObjectsMayHaveASafetyRadius) {
  EXPECT_EQ(Reading(kMinimal).config.objects[0].safety_radius, std::nullopt);
  for (const double radius : {0.0, 0.75}) {
    const std::string text = "safety_radius: " + std::to_string(radius) + "\n  keypoints: []";
    EXPECT_EQ(Reading(with("keypoints: []", text)).config.objects[0].safety_radius, radius);
  }
}

TEST(ReadConfig, NothingIsUnknownInAGroupThatIsRefused) {
  const Reading reading(plus("placement: {map: /a.yaml, mode: map}\n"));
  EXPECT_THAT(reading.root.errors(), ElementsAre(HasSubstr("placement: has a meaning")));
  EXPECT_THAT(unknownParameterErrors(reading.root, reading.root.unknownNames()),
              testing::Not(Contains(HasSubstr("placement"))));
}

struct BadSetting {
  std::string old_text;
  std::string new_text;
  std::string message;
};

class BadSettings : public ::testing::TestWithParam<BadSetting> {};

TEST_P(BadSettings, AreNamedWithWhatWouldBeRight) {
  const Reading reading(with(GetParam().old_text, GetParam().new_text));
  EXPECT_THAT(reading.root.errors(), ElementsAre(HasSubstr(GetParam().message)));
}

INSTANTIATE_TEST_SUITE_P(
    ReadConfig, BadSettings,
    ::testing::Values(
        BadSetting{"robot_list: alpha", "robot_list: []", "robot_list: found an empty list"},
        BadSetting{"robot_list: alpha", "robot_list: [alpha, alpha]", "more than once"},
        BadSetting{"robot_list: alpha", "robot_list: [alpha, labels]", "which is also a setting"},
        BadSetting{"robot_list: alpha", "robot_list: alhpa",
                   "robot_list: found 'alhpa', which has no group; did you mean 'alpha'?"},
        BadSetting{"world:", "physics: {contact_tolerance: 10}\nworld:",
                   "physics/contact_tolerance: found 10.0; it should be 0.0 to 1.0"},
        BadSetting{"world:", "labels: {keypoint_tolerance: 10}\nworld:",
                   "labels/keypoint_tolerance: found 10.0; it should be"},
        BadSetting{"keypoints: []", "keypoints: [[1, 2]]", "alpha/keypoints: found [[1, 2]]"},
        BadSetting{"keypoints: []", "keypoints: [[1, 2, x]]", "entry 1 is [1, 2, x]"},
        BadSetting{"keypoints: []", "keypoints: nose", "alpha/keypoints: found nose (a text)"},
        BadSetting{"[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]", "[]", "circumscribe"},
        BadSetting{"keypoints: []", "keypoints: {farthest_points: 0}",
                   "alpha/keypoints: found {farthest_points: 0}; farthest_points should be 1 to"},
        BadSetting{"keypoints: []", "keypoints: 'farthest_points: nine'", "should be 1 to"},
        BadSetting{"keypoints: []", "keypoints: {points: 9}",
                   "keypoints/farthest_points: required"},
        BadSetting{"keypoints: []", "keypoints: []\n  frame: a/b\n  frame_id: b",
                   "alpha/frame: found together with frame_id"},
        BadSetting{"keypoints: []", "keypoints: []\n  link_frames: '{object}'", "hold {link}"},
        BadSetting{"keypoints: []", "keypoints: []\n  link_frames: '{robot}/{link}'",
                   "hold {link}"},
        BadSetting{"keypoints: []", "keypoints: []\n  link_frames: {}", "an empty map"},
        BadSetting{"[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]", "box",
                   "alpha/bounding_shape: found 'box'; it should be model_box, or"},
        BadSetting{"keypoints: []", "keypoints: []\n  model: /a.xacro\n  model_arguments: left",
                   "alpha/model_arguments: found a text; it should be a map"},
        BadSetting{"keypoints: []", "keypoints: []\n  model: /a.urdf\n  model_arguments: {a: b}",
                   "alpha/model_arguments: found together with a model that is not a xacro file"},
        BadSetting{"class: summit", "class: [summit]", "alpha/class: found a list"},
        BadSetting{"class: summit", "class: summit\n  model: 'param:/nope'",
                   "alpha/model: found 'param:/nope', but no ROS parameter of this name"},
        BadSetting{"world:", "simulated_rate: 0\nworld:",
                   "simulated_rate: found 0.0; it should be above 0"},
        BadSetting{"world:", "simulated_rate: -5.0\nworld:", "simulated_rate: found -5.0"},
        BadSetting{"world:", "simulated_rate: fast\nworld:", "simulated_rate: found fast (a text)"},
        BadSetting{"world:", "start_offset: -1\nworld:", "start_offset: found -1.0;"},
        BadSetting{"world:", "motion: plcement\nworld:",
                   "motion: found 'plcement'; it should be bag or placement; did you mean "
                   "'placement'?"},
        BadSetting{"world:", "motion: placement\nplacement: {map: /a.yaml}\nworld:",
                   "scenes: required, but missing"},
        BadSetting{"world:", std::string(kPlaced) + "start_offset: 1\nworld:",
                   "start_offset: has a meaning with motion: bag alone"},
        BadSetting{"world:", std::string(kPlaced) + "duration: 1\nworld:",
                   "duration: has a meaning with motion: bag alone"},
        BadSetting{"world:", std::string(kPlaced) + "max_tf_gap: 1\nworld:",
                   "max_tf_gap: has a meaning with motion: bag alone"},
        BadSetting{"world:", std::string(kPlaced) + "stretch: 1\nworld:",
                   "stretch: has a meaning with motion: bag alone"},
        BadSetting{"world:", std::string(kPlaced) + "pose_topics: /odom\nworld:",
                   "pose_topics: has a meaning with motion: bag alone"},
        BadSetting{"world:", "pose_topics: [{topik: /odom}]\nworld:",
                   "pose_topics: found 'topik'; did you mean 'topic'?"},
        BadSetting{"world:", "pose_topics: [{frame: cup}]\nworld:",
                   "pose_topics: found a group without `topic`"},
        BadSetting{"world:", "pose_topics: [/odom, /odom]\nworld:",
                   "pose_topics: found '/odom' more than once"},
        BadSetting{
            "world:", "stretch: -1\nworld:", "stretch: found -1; it should be 0 to 1000000000"},
        BadSetting{"world:", "max_tf_gap: -.inf\nworld:",
                   "max_tf_gap: found -inf (a number); it should be a finite number"},
        BadSetting{
            "world:", "scenes: 5\nworld:", "scenes: has a meaning with motion: placement alone"},
        BadSetting{"world:", "motion: bag\nplacement: {map: /a.yaml}\nworld:",
                   "placement: has a meaning with motion: placement alone"},
        BadSetting{"bag_file: /data/run.bag",
                   "motion: placement\nscenes: 0\nplacement: {map: /a.yaml}",
                   "scenes: found 0; it should be 1 to 100000000"},
        BadSetting{"bag_file: /data/run.bag",
                   "motion: placement\nscenes: 100000001\nplacement: {map: /a.yaml}",
                   "scenes: found 100000001"},
        BadSetting{"keypoints: []", "safety_radius: -1\n  keypoints: []",
                   "alpha/safety_radius: found -1.0; it should be 0.0 to 1000000.0"},
        BadSetting{"robot_list: alpha", "robot_list: [alpha, placement]",
                   "robot_list: found 'placement', which is also a setting"},
        BadSetting{
            "world:", "if_exists: yes\nworld:",
            "if_exists: found 'on' (True, as YAML reads yes, no, on and off without quotes); "
            "it should be resume, overwrite or error"},
        BadSetting{"world:", "if_exists: append\nworld:",
                   "if_exists: found 'append'; it should be resume, overwrite or error"},
        BadSetting{"world:", "sync: always\nworld:",
                   "sync: found 'always'; it should be batch, scene or off"},
        BadSetting{"world:", "shard: {index: 4, count: 4}\nworld:",
                   "shard/index: found 4; it should be 0 to 3, as count is 4"},
        BadSetting{"world:", "shard: {index: 0, count: 0}\nworld:",
                   "shard/count: found 0; it should be 1 to 100000"},
        BadSetting{"world:", "shard: {index: 0}\nworld:", "shard/count: required, but missing"},
        BadSetting{"world:", "processes: 0\nworld:", "processes: found 0; it should be 1 to 1024"},
        BadSetting{"world:", "processes: 2\nshard: {index: 0, count: 4}\nworld:",
                   "processes: found 2 and a shard, which one process makes; it should be 1"},
        BadSetting{"world:", "background_subtractor: {history_length: 0}\nworld:",
                   "background_subtractor/history_length: found 0; it should be 1 to"},
        BadSetting{"world:", "rendering: {samples: 3}\nworld:", "it should be 1 or 4"},
        BadSetting{"world:", "rendering: {light: bright}\nworld:",
                   "rendering/light: found 'bright'; it should be simple or full"},
        BadSetting{"world:", "labels: {glass: tinted}\nworld:",
                   "labels/glass: found 'tinted'; it should be objects, solid or clear"},
        BadSetting{"world:", "writers: []\nworld:", "writers: found an empty list"},
        BadSetting{"[0, 0, 2, 0, 0, 0, 1]", "[0, 0, 2]", "camera/pose: found 3 numbers"},
        BadSetting{"[0, 0, 2, 0, 0, 0, 1]", "[0, 0, 2, 0, 0, 0, 0]",
                   "camera/pose: found a quaternion of length 0.0000"}));

TEST(ReadConfig, TwoObjectsCannotShareAnId) {
  const Reading reading(with("robot_list: alpha", R"(robot_list: [alpha, beta]
beta: {class: summit, id: "7", keypoints: [], bounding_shape: [[0, 0, 0]]})"));
  EXPECT_THAT(reading.root.errors(),
              ElementsAre(HasSubstr("beta/id: found 7, which is also the id of 'alpha'")));
}

TEST(ReadConfig, AnObjectCannotHaveAWritersName) {
  const Reading reading(plus("writers: [{name: alpha, type: p/T}]\n"));
  EXPECT_THAT(reading.root.errors(), Contains(HasSubstr("which is also a writer's name")));
}

TEST(UnknownParameters, AreFoundInTheGroupsThatHaveThem) {
  const Reading reading(plus("exposure_time: 0.01\n"));
  EXPECT_THAT(unknownParameterErrors(reading.root, {"exposure_time"}),
              ElementsAre("exposure_time: unknown parameter; did you mean "
                          "camera/effects/exposure_time?"));
}

TEST(UnknownParameters, AreErrorsThatSayWhatTheyMayHaveMeant) {
  const Reading reading(plus("simulated_rte: 5\nbackground_subtractor: {history_lenght: 3}\n"));
  EXPECT_THAT(
      unknownParameterErrors(reading.root, reading.root.unknownNames()),
      UnorderedElementsAre("simulated_rte: unknown parameter; did you mean 'simulated_rate'?",
                           "background_subtractor/history_lenght: unknown parameter; did you mean "
                           "'history_length'?",
                           // The writers, which are not part of this test, would have read these.
                           HasSubstr("yolo/main_list"), HasSubstr("bounding_shape/output_frame")));
}

/// Finding the nearest known name takes time, and nobody reads so many lines.
TEST(UnknownParameters, AreListedAsFarAsSomebodyMayReadThem) {
  std::string names;
  for (int i = 0; i < 20000; ++i) names += "simulated_" + std::to_string(i) + ": 1\n";
  const Reading reading(plus(names));
  const auto errors = unknownParameterErrors(reading.root, reading.root.unknownNames());
  EXPECT_EQ(errors.size(), 101U);
  EXPECT_THAT(errors.back(), HasSubstr(" more names: unknown parameters, too"));
}

TEST(UnknownParameters, BlocksOfUnusedObjectsAndWritersAreLeftInPeace) {
  const Reading reading(
      plus("writers: [{name: mine, type: p/T}]\n"
           "bravo: {class: drone, id: 3, keypoints: [], bounding_shape: [[0, 0, 0]]}\n"
           "old_writer: {output_folder: /somewhere, main_list: x}\n"));
  EXPECT_THAT(
      unknownParameterErrors(reading.root, reading.root.unknownNames()),
      UnorderedElementsAre(HasSubstr("yolo: unknown"), HasSubstr("bounding_shape: unknown")));
}

}  // namespace config_test
}  // namespace synthetic_dataset::config

#include "programs/start/settings_draft.h"

#include <algorithm>

#include <gmock/gmock.h>

#include "base/yaml_value.h"
#include "config/settings_file.h"
#include "lidar/lidar_options.h"
#include "plugins/readback/format.h"
#include "programs/start/start_line.h"
#include "run/generator.h"
#include "run/setup/run_setup.h"
#include "support/bag_builder.h"
#include "support/error_messages.h"
#include "support/source_folder.h"
#include "support/temporary_folder.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::programs {
namespace settings_draft_test {

using test::milliseconds;
using test::poseAt;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::Pair;

/// A recording of a box on wheels that drives 2 m, and its model.
class SettingsDraftTest : public ::testing::Test {
 protected:
  SettingsDraftTest() {
    test::preparePluginEnvironment();
    test::BagBuilder bag(folder / "a.bag");
    for (int i = 0; i <= 40; ++i) {
      bag.move("odom", "jackal/base_link", milliseconds(1000 + 50 * i), poseAt(0.05 * i, 0, 0));
    }
    inputs.bag_files = {bag.close()};
    inputs.contents = motion::readContents(inputs.bag_files);
    inputs.formats = {"coco", "ultralytics", "yolo"};
    const auto model = folder.write(
        "jackal.urdf",
        "<robot name='jackal'><link name='base_link'><visual><origin xyz='0 0 0.2'/><geometry><box "
        "size='0.5 0.4 0.4'/></geometry></visual></link></robot>");
    inputs.objects = {{"jackal", model.string(), 0.5}};
  }

  [[nodiscard]] Value::Map settings(const SettingsDraft& draft) const {
    const auto file = folder.write("settings.yaml", draft.text);
    return config::loadSettings(file.string(),
                                [](const std::string&) { return test::sourceFolder() + "/"; });
  }

  test::TemporaryFolder folder;
  DraftInputs inputs;
};

TEST_F(SettingsDraftTest, MakeADatasetAsTheyAre) {
  const SettingsDraft draft = draftSettings(inputs);
  EXPECT_THAT(draft.gaps, ElementsAre(HasSubstr("a pinhole of 640 x 480 stands in")));
  Value::Map settings = this->settings(draft);
  settings["only_scenes"] = Value(Value::List{Value(0), Value(20)});
  run::Reporter silent;
  run::Generator generator(Value(settings), silent, {test::pluginXml()});
  const run::RunSummary summary = generator.run();
  EXPECT_EQ(summary.scenes, 2);
  ASSERT_EQ(summary.objects.size(), 1U);
  EXPECT_EQ(summary.objects[0].scenes_labelled, 2) << "the camera looks at it";
  EXPECT_THAT(summary.warnings, IsEmpty());
}

TEST_F(SettingsDraftTest, AreRightWithEachFormatThatThereIs) {
  inputs.formats.clear();
  for (const auto& [name, type] : formats::formatNames()) {
    // The format of a lidar needs a build with Embree.
    if (name != "semantic_kitti" || lidar::canCastRays()) inputs.formats.push_back(name);
  }
  EXPECT_THAT(inputs.formats, AllOf(Contains("mot"), Contains("kitti_tracking"),
                                    Contains("labelme"), Contains("pascal_voc")));
  const Value settings(this->settings(draftSettings(inputs)));
  EXPECT_EQ(settings.as<Value::Map>()->at("writers").as<Value::List>()->size(),
            inputs.formats.size());
  EXPECT_THAT(test::messagesOf([&] { (void)run::setUpRun(settings, {test::pluginXml()}); }),
              IsEmpty());
}

TEST_F(SettingsDraftTest, MarkWhatIsNotKnown) {
  inputs.objects = {{"jackal", std::nullopt, 0.0}};
  inputs.contents.descriptions = {{"/robot_description", "jackal", "<robot name='jackal'/>"}};
  const SettingsDraft draft = draftSettings(inputs);
  EXPECT_THAT(draft.text, HasSubstr("# model: /path/to/jackal.urdf  # TODO: a model of jackal"));
  EXPECT_THAT(draft.gaps, Contains(AllOf(HasSubstr("a model of jackal"),
                                         HasSubstr("`inspect --urdf BAG > jackal.urdf`"))));
}

TEST_F(SettingsDraftTest, KeepTheRateOfTheRecordingAndLeaveOutWhereNothingMoves) {
  EXPECT_THAT(draftSettings(inputs).text, HasSubstr("simulated_rate: 20.0\n"));
  EXPECT_THAT(draftSettings(inputs).text, Not(HasSubstr("start_offset")));
  test::BagBuilder bag(folder / "b.bag");
  for (int i = 0; i <= 400; ++i) {
    bag.move("odom", "jackal/base_link", milliseconds(1000 + 100 * i),
             poseAt(0.05 * std::clamp(i - 100, 0, 200), 0, 0));
  }
  inputs.bag_files = {bag.close()};
  inputs.contents = motion::readContents(inputs.bag_files);
  const Value::Map given = settings(draftSettings(inputs));
  EXPECT_NEAR(*given.at("start_offset").as<double>(), 10.0, 0.2);
  EXPECT_NEAR(*given.at("duration").as<double>(), 20.0, 0.3);
}

TEST_F(SettingsDraftTest, PutACameraNearTheObjectWhereThereMayBeWalls) {
  inputs.world = "/hall.world";
  const std::string text = draftSettings(inputs).text;
  EXPECT_THAT(text, HasSubstr("world:\n  file: \"/hall.world\"\n\n"));
  EXPECT_THAT(text, HasSubstr("sample: {look_at: any, distance: {uniform: [1.5, 4.0]}"));
}

TEST_F(SettingsDraftTest, TakeTheRecordedCalibrationAndNameOtherPrefixes) {
  test::BagBuilder bag(folder / "b.bag");
  bag.calibrate("/eye/camera_info", "eye", milliseconds(1000), 140);
  for (int i = 0; i <= 40; ++i) {
    bag.move("odom", "base_link", milliseconds(1000 + 50 * i), poseAt(0.05 * i, 0, 0));
  }
  inputs.bag_files = {bag.close()};
  inputs.contents = motion::readContents(inputs.bag_files);
  const SettingsDraft draft = draftSettings(inputs);
  EXPECT_THAT(draft.text, HasSubstr("info_topic: \"/eye/camera_info\""));
  EXPECT_THAT(draft.text, HasSubstr("frame: \"base_link\"\n  link_frames: \"{link}\""));
  EXPECT_THAT(draft.gaps, IsEmpty());
}

TEST_F(SettingsDraftTest, MakePicturesForNetworksUnlessThereAreRecordedOnes) {
  EXPECT_THAT(draftSettings(inputs).text, HasSubstr("\nrandomize: {preset: transfer}\n"));
  inputs.world = "/hall.world";
  EXPECT_THAT(draftSettings(inputs).text, HasSubstr("\nrandomize: {preset: transfer}\n"));
  inputs.contents.topics.push_back({"/eye/image_raw", "sensor_msgs/Image", ""});
  const SettingsDraft draft = draftSettings(inputs);
  EXPECT_THAT(draft.text, HasSubstr("`camera: {image_topic: /eye/image_raw}` labels these"));
  EXPECT_THAT(draft.text, HasSubstr("\n# randomize: {preset: transfer}\n"));
}

TEST_F(SettingsDraftTest, FollowOdometryWhereThereIsNoTf) {
  test::BagBuilder bag(folder / "b.bag");
  for (int i = 0; i <= 40; ++i) {
    bag.drive("/odom", "odom", "base_footprint", milliseconds(1000 + 50 * i),
              poseAt(0.05 * i, 0, 0));
  }
  inputs.bag_files = {bag.close()};
  inputs.contents = motion::readContents(inputs.bag_files);
  EXPECT_THAT(inputs.contents.notes,
              ElementsAre("without TF, frames come from /odom (nav_msgs/Odometry)"));
  const SettingsDraft draft = draftSettings(inputs);
  EXPECT_THAT(draft.text,
              AllOf(HasSubstr("frame: \"base_footprint\""), HasSubstr("global_frame: \"odom\""),
                    HasSubstr("pose_topics: [\"/odom\"]")));
  const run::RunSetup setup = run::setUpRun(Value(settings(draft)), {test::pluginXml()});
  EXPECT_THAT(setup.diagnostics.messages(base::Severity::kWarning), IsEmpty());
}

TEST_F(SettingsDraftTest, SayHowPosesWithoutAFrameAreRead) {
  test::BagBuilder bag(folder / "b.bag");
  bag.locate("/mocap", "world", milliseconds(1000), poseAt(0, 0, 0));
  inputs.bag_files = {bag.locate("/mocap", "world", milliseconds(2000), poseAt(1, 0, 0)).close()};
  inputs.contents = motion::readContents(inputs.bag_files);
  inputs.objects.clear();
  EXPECT_THAT(draftSettings(inputs).gaps,
              Contains(HasSubstr("pose_topics: [{topic: /mocap, frame: NAME}]")));
}

TEST(ObjectNames, AreNoSettings) {
  EXPECT_EQ(objectNameOf({"jackal", "jackal", "jackal/base_link"}), "jackal");
  EXPECT_EQ(objectNameOf({"camera", "camera", "camera/base_link"}), "camera_robot");
}

TEST(StartLine, NamesBagsAndWhatBelongsToThem) {
  const StartLine line =
      parseStartLine({"a.bag", "b.bag", "--model", "husky=h.urdf", "--model=cup=c", "--world",
                      "w.sdf", "-o", "my.yaml", "--formats", "coco,yolo"});
  EXPECT_THAT(line.bag_files, ElementsAre("a.bag", "b.bag"));
  EXPECT_THAT(line.models, ElementsAre(Pair("husky", "h.urdf"), Pair("cup", "c")));
  EXPECT_EQ(line.world, "w.sdf");
  EXPECT_EQ(line.output, "my.yaml");
  EXPECT_THAT(*line.formats, ElementsAre("coco", "yolo"));
}

TEST(StartLine, RefusesWhatItDoesNotKnow) {
  const auto messageOf = [](const std::vector<std::string>& arguments) {
    return test::messagesOf([&] { (void)parseStartLine(arguments); });
  };
  EXPECT_THAT(messageOf({}), ElementsAre(HasSubstr("found no bag")));
  EXPECT_THAT(messageOf({"a.bag", "--wrld", "x"}), ElementsAre(HasSubstr("found '--wrld'")));
  EXPECT_THAT(messageOf({"a.bag", "--model", "husky.urdf"}),
              ElementsAre(HasSubstr("it should be NAME=FILE")));
  EXPECT_THAT(messageOf({"a.bag", "-o"}), ElementsAre(HasSubstr("-o: nothing follows")));
  EXPECT_THAT(messageOf({"a.bag", "-o", "x", "-o", "y"}), ElementsAre(HasSubstr("a second one")));
}

}  // namespace settings_draft_test
}  // namespace synthetic_dataset::programs

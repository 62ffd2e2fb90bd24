#include "run/setup/transfer_preset.h"

#include <string>

#include <gmock/gmock.h>

#include "base/yaml_value.h"
#include "config/settings_file.h"
#include "run/setup/run_setup.h"
#include "support/error_messages.h"
#include "support/source_folder.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::run {
namespace transfer_preset_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Settings of one model and nothing else.
std::string ofRover(const std::string& more = "") {
  const std::string worlds = test::sourceFolder() + "/worlds/";
  return "motion: placement\nscenes: 10\n"
         "camera: {info_file: " +
         worlds +
         "pinhole.yaml}\n"
         "robot_list: [rover]\n"
         "rover: {class: rover, id: 1, model: " +
         worlds +
         "models/rover, count: 3}\n"
         "writers: [{name: coco, type: synthetic_dataset/Coco}]\n"
         "output_folder: /tmp/never_written\n" +
         more;
}

class TransferPresetTest : public ::testing::Test {
 protected:
  TransferPresetTest() { test::preparePluginEnvironment(); }

  Value::Map expanded(const std::string& settings) {
    ExpandedPreset preset = expandPreset(
        Value(config::asParameters(base::parseYaml(settings, "test"), "test")), inputs_);
    notes_ = preset.notes;
    return *preset.settings.as<Value::Map>();
  }

  static Value at(const Value::Map& settings, const std::string& path) {
    Value value(settings);
    std::size_t begin = 0;
    while (begin <= path.size()) {
      const std::size_t end = std::min(path.find('/', begin), path.size());
      const auto* map = value.as<Value::Map>();
      const auto found = map == nullptr ? Value::Map::const_iterator()
                                        : map->find(path.substr(begin, end - begin));
      if (map == nullptr || found == map->end()) return Value("nothing");
      const Value next = found->second;
      value = next;
      begin = end + 1;
    }
    return value;
  }

  static Value::Map motion(const Value::Map& settings, std::size_t index) {
    return *(*settings.at("motions").as<Value::List>()).at(index).as<Value::Map>();
  }

  InputCache inputs_;
  std::vector<std::string> notes_;
};

TEST_F(TransferPresetTest, LeavesOtherSettingsAsTheyAre) {
  const std::string plain = ofRover("randomize: {ambient: 0.5}\n");
  EXPECT_EQ(Value(expanded(plain)),
            Value(config::asParameters(base::parseYaml(plain, "test"), "test")));
}

TEST_F(TransferPresetTest, IsSettingsOfWhichNoneIsWrong) {
  const Value settings = Value(
      config::asParameters(base::parseYaml(ofRover("randomize: {preset: transfer}\n"), "t"), "t"));
  EXPECT_THAT(test::messagesOf([&] { (void)setUpRun(settings, {test::pluginXml()}); }), IsEmpty());
}

TEST_F(TransferPresetTest, HasLengthsInSizesOfTheLargestObject) {
  const auto widthOf = [&](const std::string& model) {
    std::string settings = ofRover("randomize: {preset: transfer}\n");
    settings.replace(settings.find("models/rover"), 12, "models/" + model);
    const Value::Map room = *at(motion(expanded(settings), 3), "randomize/room").as<Value::Map>();
    return *(*room.at("size").as<Value::List>())[0].as<double>();
  };
  const double rover = widthOf("rover");
  EXPECT_GT(rover, 3.0);
  EXPECT_LT(rover, 30.0);
  EXPECT_NE(rover, widthOf("drone"));
}

TEST_F(TransferPresetTest, IsOverriddenByWhatStandsBesideIt) {
  const Value::Map settings =
      expanded(ofRover("rendering: {light: simple}\n"
                       "randomize: {preset: transfer, variety: same_class, weather: {rain: 3}, "
                       "distractors: {count: 2}}\n"));
  EXPECT_EQ(at(settings, "rendering/light"), Value("simple"));
  EXPECT_EQ(at(settings, "randomize/variety"), Value("same_class"));
  EXPECT_EQ(at(settings, "randomize/preset"), Value("nothing"));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(at(motion(settings, i), "randomize/weather/rain"), Value(std::int64_t{3})) << i;
    EXPECT_EQ(at(motion(settings, i), "randomize/distractors/count"), Value(std::int64_t{2})) << i;
  }
}

TEST_F(TransferPresetTest, HasPicturesWithoutObjectsUnlessItIsSaidWhichAreThere) {
  const Value::Map settings = expanded(ofRover("randomize: {preset: transfer}\n"));
  EXPECT_EQ(at(settings, "randomize/object_count/choice").text(), "[0, 1]");
  const Value::Map own =
      expanded(ofRover("randomize: {preset: transfer, objects: {every: {present: 0.5}}}\n"));
  EXPECT_EQ(at(own, "randomize/object_count"), Value("nothing"));
}

TEST_F(TransferPresetTest, KeepsACameraThatHasAPlace) {
  std::string settings = ofRover("randomize: {preset: transfer}\n");
  settings.replace(settings.find("pinhole.yaml}"), 13,
                   "pinhole.yaml, pose: [0, 0, 1, 0, 0, 0, 1]}");
  const Value::Map result = expanded(settings);
  EXPECT_EQ(at(result, "camera/sample"), Value("nothing"));
  EXPECT_EQ(at(motion(result, 1), "camera/sample"), Value("nothing"));
}

TEST_F(TransferPresetTest, LeavesPosesAndCamerasOfARecordingAlone) {
  const Value::Map settings = expanded(
      "bag_file: walk.bag\nworld: hall.sdf\nrobot_list: [rover]\nrandomize: {preset: transfer}\n");
  for (const char* name : {"motions", "placement", "camera", "labels"}) {
    EXPECT_EQ(at(settings, name), Value("nothing")) << name;
  }
  EXPECT_EQ(at(settings, "randomize/objects"), Value("nothing"));
  EXPECT_EQ(at(settings, "randomize/variety"), Value("same_object"));
  EXPECT_EQ(at(settings, "randomize/object_count"), Value("nothing"));
  EXPECT_EQ(at(settings, "randomize/distractors/mode"), Value("stand"));
  EXPECT_THAT(notes_, ElementsAre(HasSubstr("a recording")));
}

TEST_F(TransferPresetTest, PutsNothingInFrontOfWhatIsInRecordedPictures) {
  const Value::Map settings = expanded(
      "bag_file: walk.bag\nworld: hall.sdf\nrobot_list: [rover]\nrandomize: {preset: transfer}\n"
      "camera: {image_topic: /front/image}\n");
  EXPECT_EQ(at(settings, "randomize/distractors"), Value("nothing"));
  EXPECT_EQ(at(settings, "randomize/background/pictures"), Value("natural"));
}

}  // namespace transfer_preset_test
}  // namespace synthetic_dataset::run

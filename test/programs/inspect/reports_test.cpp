#include <gmock/gmock.h>

#include "base/json_text.h"
#include "base/yaml_value.h"
#include "programs/inspect/bag_report.h"
#include "programs/inspect/world_report.h"
#include "support/bag_builder.h"
#include "support/error_messages.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::programs {
namespace reports_test {

using test::milliseconds;
using test::poseAt;
using ::testing::AllOf;
using ::testing::HasSubstr;

motion::BagContents contentsOfARecording(const test::TemporaryFolder& folder) {
  test::BagBuilder bag(folder / "a.bag");
  bag.fix("base_link", "lidar", milliseconds(1000));
  for (int i = 0; i <= 20; ++i) {
    bag.move("odom", "base_link", milliseconds(1000 + 50 * i), poseAt(0.1 * i, 0, 0));
  }
  return motion::readContents({bag.close()});
}

TEST(BagText, ShowsFramesAsATree) {
  const test::TemporaryFolder folder;
  const std::string text = bagText(contentsOfARecording(folder), {});
  EXPECT_THAT(text,
              HasSubstr("  odom  (root)\n"
                        "    base_link  (20.0 Hz, 1.000 s to 2.000 s, travels in 2.00 x 0.00 x "
                        "0.00 m)\n"
                        "      lidar  (static"));
  EXPECT_THAT(text, HasSubstr("kind: bag of ROS 1\n"));
  EXPECT_THAT(text, AllOf(HasSubstr("robot: robot, whose frame is 'base_link'"),
                          HasSubstr("  /tf  (tf2_msgs/TFMessage)")));
}

TEST(BagValue, IsTheSameForPrograms) {
  const test::TemporaryFolder folder;
  const Value value =
      base::parseYaml(base::jsonText(bagValue(contentsOfARecording(folder), {})), "json");
  const auto& map = *value.as<Value::Map>();
  const auto& frames = *map.at("frames").as<Value::List>();
  ASSERT_EQ(frames.size(), 2U);
  const auto& base = *frames[0].as<Value::Map>();
  EXPECT_EQ(base.at("name"), Value("base_link"));
  EXPECT_NEAR(*base.at("rate").as<double>(), 20.0, 1e-9);
  EXPECT_EQ(map.at("robots").as<Value::List>()->size(), 1U);
}

TEST(BagText, NamesRobotDescriptions) {
  const test::TemporaryFolder folder;
  const std::string urdf = "<?xml version='1.0'?><robot\n name = 'jackal'><link name='l'/></robot>";
  test::BagBuilder bag(folder / "a.bag");
  bag.move("odom", "base_link", milliseconds(1000));
  bag.say("/robot_description", milliseconds(1000), urdf);
  bag.say("/arm/robot_description", milliseconds(1000), "no URDF");
  bag.say("/chatter", milliseconds(1000), urdf);
  const auto contents = motion::readContents({bag.close()});
  ASSERT_EQ(contents.descriptions.size(), 1U);
  EXPECT_EQ(contents.descriptions[0].urdf, urdf);
  EXPECT_THAT(bagText(contents, {{"/robot_description", "husky"}}),
              AllOf(HasSubstr("model: /robot_description is a URDF of 'jackal' (`inspect --urdf "
                              "BAG > jackal.urdf` saves it)\n"),
                    HasSubstr("model on the parameter server: /robot_description is a URDF of "
                              "'husky' (`rosparam get -p /robot_description > husky.urdf`")));
  const Value value = bagValue(contents, {{"/robot_description", "husky"}});
  EXPECT_EQ(value.as<Value::Map>()->at("models").as<Value::List>()->size(), 2U);
}

TEST(WorldText, OfAFileThatIsMissingIsAnError) {
  EXPECT_THAT(test::messagesOf([] { (void)readForInspection("no_such.world"); }),
              ::testing::ElementsAre(HasSubstr("no_such.world': no such file")));
}

constexpr const char* kWorld =
    "<sdf version='1.6'><world name='w'>"
    "<light name='lamp' type='point'><pose>1 2 3 0 0 0</pose><cast_shadows>true</cast_shadows>"
    "<attenuation><range>12</range></attenuation></light>"
    "<model name='box'><static>true</static><pose>4 5 0.5 0 0 0</pose><link name='l'><visual "
    "name='v'><geometry><box><size>1 2 3</size></box></geometry></visual></link></model>"
    "<model name='gone'><link name='l'><visual name='v'><geometry><mesh><uri>gone.dae</uri></mesh>"
    "</geometry></visual></link></model></world></sdf>";

TEST(WorldText, ShowsModelsLightsAndWhatIsMissing) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("a.world", kWorld);
  const std::string text = worldText(readForInspection(file));
  EXPECT_THAT(text, HasSubstr("model box: 1.00 x 2.00 x 3.00 m, at [4.00, 5.00, 0.50], static, 1 "
                              "link\n"));
  EXPECT_THAT(text, HasSubstr("light lamp: point, at [1.00, 2.00, 3.00], reaches 12.0 m, casts "
                              "shadows\n"));
  EXPECT_THAT(text, HasSubstr("gone.dae"));
  const Value value = worldValue(readForInspection(file));
  EXPECT_EQ(value.as<Value::Map>()->at("models").as<Value::List>()->size(), 2U);
}

TEST(WorldText, ShowsAModelsLinksAndJoints) {
  const test::TemporaryFolder folder;
  const auto file = folder.write(
      "arm.urdf",
      "<robot name='arm'><link name='base'><visual><geometry><box size='1 1 0.1'/></geometry>"
      "</visual></link><link name='upper'><visual><geometry><box size='0.1 0.1 1'/></geometry>"
      "</visual></link><joint name='shoulder' type='revolute'><parent link='base'/><child "
      "link='upper'/><origin xyz='0 0 0.5'/><axis xyz='0 1 0'/><limit lower='-1' upper='1' "
      "effort='1' velocity='1'/></joint></robot>");
  EXPECT_THAT(worldText(readForInspection(file)),
              HasSubstr("link upper, on base by the joint shoulder"));
}

}  // namespace reports_test
}  // namespace synthetic_dataset::programs

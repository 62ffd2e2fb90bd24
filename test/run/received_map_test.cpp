#include "randomize/placement/received_map.h"

#include <filesystem>

#include <gmock/gmock.h>

#include "all_at_once_run.h"
#include "base/yaml_value.h"
#include "run/merger.h"
#include "support/bag_builder.h"
#include "support/error_messages.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::run {
namespace received_map_test {

namespace fs = std::filesystem;
using test::AllAtOnceRun;
using test::poseAt;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Value yaml(const std::string& text) { return base::parseYaml(text, "test"); }

/// A map that is free except in one corner.
motion::RecordedMap hall() {
  motion::RecordedMap map;
  map.width = 24;
  map.height = 20;
  map.resolution = 0.125;
  map.X_FM = poseAt(-1.5, -1.25, 0.0, 0.1);
  map.frame = "map";
  map.cells.assign(24 * 20, 0);
  for (std::size_t i = 0; i < 7; ++i) map.cells[i] = 100;
  map.cells[30] = -1;
  return map;
}

/// The errors of the hall's settings with one of them replaced.
std::vector<std::string> errorsWith(const std::string& name, const Value& value) {
  Value settings = randomize::settingsOf(hall());
  (*settings.as<Value::Map>())[name] = value;
  return test::messagesOf([&] { (void)randomize::receivedMap(settings); });
}

TEST(ReceivedMap, OfMoreCellsThanThereIsRoomForIsNamed) {
  Value settings = randomize::settingsOf(hall());
  for (const char* side : {"width", "height"}) {
    (*settings.as<Value::Map>())[side] = Value(1000000);
  }
  EXPECT_THAT(test::messagesOf([&] { (void)randomize::receivedMap(settings); }),
              ElementsAre(HasSubstr("width: found 1000000 x 1000000 cells")));
}

TEST(ReceivedMap, IsTheSameAfterItsSettings) {
  const Value settings = randomize::settingsOf(hall());
  EXPECT_EQ(*settings.as<Value::Map>()->at("cells").as<std::string>(), "100x7 0x23 -1x1 0x449");
  const motion::RecordedMap map = randomize::receivedMap(settings);
  EXPECT_EQ(map.width, 24U);
  EXPECT_EQ(map.height, 20U);
  EXPECT_EQ(map.resolution, 0.125);
  EXPECT_EQ(map.frame, "map");
  EXPECT_TRUE(map.X_FM.isApprox(hall().X_FM, 1e-12));
  EXPECT_EQ(map.cells, hall().cells);
}

TEST(ReceivedMap, NamesWhatIsWrong) {
  EXPECT_THAT(errorsWith("cells", Value("100x7 0x23")),
              ElementsAre(HasSubstr("placement/received_map/cells: it should be runs")));
  EXPECT_THAT(errorsWith("cells", Value("0x480 1x1")), ElementsAre(HasSubstr("/cells")));
  EXPECT_THAT(errorsWith("cells", Value("300x480")), ElementsAre(HasSubstr("/cells")));
  EXPECT_THAT(errorsWith("cells", Value("0x470 free")), ElementsAre(HasSubstr("/cells")));
  EXPECT_THAT(errorsWith("width", Value(0)), Contains(HasSubstr("/width: found 0")));
  EXPECT_THAT(errorsWith("origin", yaml("[1, 2]")), ElementsAre(HasSubstr("/origin: found 2")));
  EXPECT_THAT(errorsWith("resolution", Value(0.0)), ElementsAre(HasSubstr("resolution of 0")));
}

/// A run without a recording, on a map that a running system has sent.
class RunOnReceivedMap : public ::testing::Test {
 protected:
  RunOnReceivedMap() {
    run.parameters.erase("bag_file");
    run.parameters["motion"] = Value("placement");
    run.parameters["scenes"] = Value(4);
    receive(hall());
  }

  void receive(const motion::RecordedMap& map) {
    run.parameters["placement"] =
        Value::Map{{"map_topic", Value("/map")}, {"received_map", randomize::settingsOf(map)}};
  }

  AllAtOnceRun run;
};

TEST_F(RunOnReceivedMap, PlacesObjectsAsOnTheSameMapInABag) {
  (void)run.run();
  auto received = AllAtOnceRun::files(run.folder());
  fs::remove_all(run.folder());
  test::BagBuilder::Map map;
  map.recorded = test::milliseconds(1000);
  map.width = 24;
  map.height = 20;
  map.resolution = 0.125F;
  map.X_FM = hall().X_FM;
  map.cells = hall().cells;
  const std::string bag = run.input("map.bag");
  run.parameters["bag_file"] = Value(test::BagBuilder(bag).map(map).close());
  run.parameters["placement"] = Value::Map{{"map_topic", Value("/map")}};
  (void)run.run();
  for (const auto& [name, bytes] : AllAtOnceRun::files(run.folder())) {
    if (name == "manifest.sqlite") continue;
    EXPECT_TRUE(received[name] == bytes) << name;
  }
}

TEST_F(RunOnReceivedMap, GoesOnWithTheSameMapAlone) {
  test::StoppingReporter stopping(2);
  EXPECT_TRUE(run.run(stopping, run.folder()).stopped);
  motion::RecordedMap changed = hall();
  changed.cells[200] = 100;
  receive(changed);
  EXPECT_THAT(run.errors(), Contains(HasSubstr("placement/received_map/cells")));
  receive(hall());
  EXPECT_EQ(run.run().dataset_scenes, 8);
}

TEST_F(RunOnReceivedMap, IsMergedWhereNothingRuns) {
  (void)run.run();
  const auto expected = AllAtOnceRun::files(run.folder());
  fs::remove_all(run.folder());
  for (const int index : {0, 1}) (void)run.runShard(index, 2, run.folder());
  Reporter silent;
  mergeShards(run.folder(), {}, silent, {test::pluginXml()});
  EXPECT_TRUE(AllAtOnceRun::files(run.folder()) == expected);
}

TEST_F(RunOnReceivedMap, NamesAMapOfAnotherFrame) {
  motion::RecordedMap elsewhere = hall();
  elsewhere.frame = "odom";
  receive(elsewhere);
  EXPECT_THAT(run.errors(),
              ElementsAre(AllOf(HasSubstr("placement/map_topic: "), HasSubstr("'odom'"),
                                HasSubstr("global_frame, 'map'"))));
}

TEST_F(RunOnReceivedMap, TellsWhereAMapMayComeFrom) {
  run.parameters["placement"] = Value::Map{{"map_topic", Value("/map")}};
  EXPECT_THAT(run.errors(), ElementsAre(AllOf(HasSubstr("placement/map_topic: found '/map'"),
                                              HasSubstr("bag_file"), HasSubstr("as a node"),
                                              HasSubstr("placement/map should"))));
}

}  // namespace received_map_test
}  // namespace synthetic_dataset::run

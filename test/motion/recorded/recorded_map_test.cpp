#include "motion/recorded/recorded_map.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "motion/recorded.h"
#include "support/bag_builder.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::motion {
namespace recorded_map_test {

using test::BagBuilder;
using test::milliseconds;
using test::poseAt;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class RecordedMapTest : public ::testing::Test {
 protected:
  /// A map of 3 x 2 cells, whose first cell is given.
  static BagBuilder::Map mapAt(std::int64_t recorded_ms, std::int8_t first_cell = 0) {
    BagBuilder::Map map;
    map.recorded = milliseconds(recorded_ms);
    map.width = 3;
    map.height = 2;
    map.cells = {first_cell, 10, 20, 100, -1, 50};
    return map;
  }

  [[nodiscard]] std::string bagOf(const std::string& name,
                                  const std::vector<BagBuilder::Map>& maps) const {
    BagBuilder bag(folder / name);
    bag.say("/chatter", milliseconds(900));
    for (const BagBuilder::Map& map : maps) bag.map(map);
    return bag.close();
  }

  /// The error of reading a bag with only this map.
  [[nodiscard]] std::string errorOf(const BagBuilder::Map& map) const {
    const std::string bag = bagOf("wrong.bag", {map});
    return messageOf([&] { static_cast<void>(readMap({bag}, "/map")); });
  }

  test::TemporaryFolder folder;
};

TEST_F(RecordedMapTest, HasTheMessagesCellsAndPlace) {
  BagBuilder::Map written = mapAt(1000);
  written.frame = "/floor";
  written.X_FM = poseAt(1.5, -2.0, 0.25, 0.7);
  const RecordedMap map = readMap({bagOf("run.bag", {written})}, "map");
  EXPECT_EQ(map.width, 3U);
  EXPECT_EQ(map.height, 2U);
  EXPECT_EQ(map.resolution, 0.5);
  EXPECT_EQ(map.frame, "floor");
  EXPECT_TRUE(map.X_FM.isApprox(written.X_FM, 1e-12));
  EXPECT_THAT(map.cells, ElementsAre(0, 10, 20, 100, -1, 50));
}

TEST_F(RecordedMapTest, IsTheLastOfItsTopic) {
  const std::string bag = bagOf("run.bag", {mapAt(1000, 1), mapAt(3000, 3), mapAt(2000, 2)});
  EXPECT_EQ(readMap({bag}, "/map").cells.front(), 3);
}

TEST_F(RecordedMapTest, IsTheLastOfAllBagsInWhateverOrder) {
  const std::string late = bagOf("late.bag", {mapAt(5000, 5)});
  const std::string early = bagOf("early.bag", {mapAt(4000, 4)});
  const std::string none = bagOf("none.bag", {});
  EXPECT_EQ(readMap({late, early, none}, "/map").cells.front(), 5);
  EXPECT_EQ(readMap({none, early, late}, "/map").cells.front(), 5);
}

TEST_F(RecordedMapTest, IsNoneOfAnotherTopic) {
  BagBuilder::Map costs = mapAt(9000, 9);
  costs.topic = "/costmap";
  const std::string bag = bagOf("run.bag", {mapAt(1000, 1), costs});
  EXPECT_EQ(readMap({bag}, "/map").cells.front(), 1);
}

TEST_F(RecordedMapTest, NeedsNothingOfEarlierMaps) {
  BagBuilder::Map empty;  // what mappers send before they know anything
  empty.recorded = milliseconds(500);
  const std::string bag = bagOf("run.bag", {empty, mapAt(1000, 1)});
  EXPECT_EQ(readMap({bag}, "/map").cells.front(), 1);
}

TEST_F(RecordedMapTest, NamesTheTopicsThatThereAre) {
  const std::string bag = bagOf("run.bag", {mapAt(1000)});
  EXPECT_THAT(messageOf([&] { static_cast<void>(readMap({bag}, "/mop")); }),
              AllOf(HasSubstr("found '/mop', a topic that the recording does not have"),
                    HasSubstr("of type nav_msgs/OccupancyGrid it has /map; did you mean '/map'?")));
}

TEST_F(RecordedMapTest, NamesTheTypeOfATopicThatIsNoMap) {
  const std::string bag = bagOf("run.bag", {});
  EXPECT_THAT(messageOf([&] { static_cast<void>(readMap({bag}, "/chatter")); }),
              AllOf(HasSubstr("whose messages are std_msgs/String"),
                    HasSubstr("they should be nav_msgs/OccupancyGrid")));
}

TEST_F(RecordedMapTest, HasACellForEachOfItsPlaces) {
  BagBuilder::Map map = mapAt(1000);
  map.cells.pop_back();
  EXPECT_THAT(errorOf(map), HasSubstr("the last map of '/map': found a map of 3 x 2 cells with 5 "
                                      "values; it should have one for each cell"));
  // The product of its sides is 0 in 32 bits.
  map.width = map.height = 65536;
  EXPECT_THAT(errorOf(map), HasSubstr("found a map of 65536 x 65536 cells with 5 values"));
}

TEST_F(RecordedMapTest, HasCells) {
  BagBuilder::Map map = mapAt(1000);
  map.width = 0;
  map.cells.clear();
  EXPECT_THAT(errorOf(map), HasSubstr("found a map of 0 x 2 cells; it should have some"));
}

TEST_F(RecordedMapTest, HasCellsOfASize) {
  BagBuilder::Map map = mapAt(1000);
  map.resolution = 0.0F;
  EXPECT_THAT(errorOf(map), HasSubstr("found a resolution of 0.0 m; it should be above 0"));
  map.resolution = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(errorOf(map), HasSubstr("it should be above 0"));
}

TEST_F(RecordedMapTest, HasAPlace) {
  BagBuilder::Map map = mapAt(1000);
  map.X_FM = poseAt(std::numeric_limits<double>::infinity(), 0.0, 0.0);
  EXPECT_THAT(errorOf(map), HasSubstr("found an origin that is not a pose"));
}

TEST_F(RecordedMapTest, IsNotTurnedWithoutAnOrientation) {
  // All of the quaternion's numbers are 0, as from a sender that sets no orientation.
  BagBuilder::Map map = mapAt(1000);
  std::string content = test::readFile(bagOf("run.bag", {map}));
  const std::string one("\0\0\0\0\0\0\xF0\x3F", 8);                   // w = 1
  const std::string place_of_w = one + std::string("\x06\0\0\0", 4);  // the number of cells follows
  content.replace(content.find(place_of_w), one.size(), one.size(), '\0');
  const std::string bag = folder.write("changed.bag", content).string();
  EXPECT_TRUE(readMap({bag}, "/map").X_FM.isApprox(Pose::Identity()));
}

TEST_F(RecordedMapTest, RefusesCellsThatTheMessageHasNoBytesFor) {
  std::string content = test::readFile(bagOf("run.bag", {mapAt(1000)}));
  const std::string count("\x06\0\0\0", 4);
  const std::string cells("\x00\x0A\x14\x64\xFF\x32", 6);
  content.replace(content.find(count + cells), 4, "\xFF\xFF\xFF\x0F");
  const std::string bag = folder.write("changed.bag", content).string();
  EXPECT_THAT(messageOf([&] { static_cast<void>(readMap({bag}, "/map")); }),
              AllOf(HasSubstr("bag " + bag),
                    HasSubstr("its list of cells is said to have 268435455 entries")));
}

}  // namespace recorded_map_test
}  // namespace synthetic_dataset::motion

#include "randomize/placement/occupancy_map.h"

#include <limits>

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::randomize {
namespace occupancy_map_test {

using ::testing::HasSubstr;

constexpr Cell kFree = Cell::kFree;
constexpr Cell kOccupied = Cell::kOccupied;
constexpr Cell kUnknown = Cell::kUnknown;
constexpr double kQuarterTurn = 1.5707963267948966;

/// 3 x 2 cells of 0.5 m:   row 1: free  occupied  unknown
///                         row 0: free  free      free
OccupancyMap smallMap(const MapPose& X_GM = {}) {
  return {3, 2, 0.5, X_GM, {kFree, kFree, kFree, kFree, kOccupied, kUnknown}};
}

TEST(OccupancyMap, HasItsCellsFromTheLowerLeftOn) {
  const OccupancyMap map = smallMap();
  EXPECT_EQ(map.cell(1, 0), kFree);
  EXPECT_EQ(map.cell(1, 1), kOccupied);
  EXPECT_EQ(map.cellAt({0.75, 0.25}), kFree);
  EXPECT_EQ(map.cellAt({0.75, 0.75}), kOccupied);
  EXPECT_EQ(map.cellAt({1.25, 0.75}), kUnknown);
}

TEST(OccupancyMap, HasNoCellsOutside) {
  const OccupancyMap map = smallMap();
  for (const Eigen::Vector2d& place :
       {Eigen::Vector2d(-0.01, 0.2), {0.2, -0.01}, {1.51, 0.2}, {0.2, 1.01}, {1e300, 0.2}}) {
    EXPECT_EQ(map.cellAt(place), std::nullopt);
    EXPECT_FALSE(map.isFree(place));
  }
  EXPECT_EQ(map.cellAt({std::numeric_limits<double>::quiet_NaN(), 0.2}), std::nullopt);
}

TEST(OccupancyMap, HasTheLowerSidesOfItsCellsButNotTheUpper) {
  const OccupancyMap map = smallMap();
  EXPECT_EQ(map.cellAt({0.0, 0.0}), kFree);
  EXPECT_EQ(map.cellAt({0.5, 0.5}), kOccupied);
  EXPECT_EQ(map.cellAt({1.5, 0.0}), std::nullopt);
  EXPECT_EQ(map.cellAt({0.0, 1.0}), std::nullopt);
}

TEST(OccupancyMap, IsFreeWhereItIsKnownToBe) {
  const OccupancyMap map = smallMap();
  EXPECT_TRUE(map.isFree({0.25, 0.75}));
  EXPECT_FALSE(map.isFree({0.75, 0.75}));
  EXPECT_FALSE(map.isFree({1.25, 0.75}));
}

TEST(OccupancyMap, IsTurnedAboutItsLowerLeftCorner) {
  // The map's x points along the global y, its y against the global x.
  const OccupancyMap map = smallMap({10.0, 20.0, 0.0, kQuarterTurn});
  EXPECT_EQ(map.cellAt({10.0 - 0.75, 20.0 + 0.75}), kOccupied);
  EXPECT_EQ(map.cellAt({10.0 - 0.25, 20.0 + 1.25}), kFree);
  EXPECT_EQ(map.cellAt({10.0 + 0.25, 20.0 + 0.25}), std::nullopt);
}

TEST(OccupancyMap, TellsPlacesInBothFrames) {
  const OccupancyMap map = smallMap({10.0, 20.0, 3.0, kQuarterTurn});
  EXPECT_TRUE(map.toGlobal({1.25, 0.75}).isApprox(Eigen::Vector2d(9.25, 21.25)));
  EXPECT_TRUE(map.toMap({9.25, 21.25}).isApprox(Eigen::Vector2d(1.25, 0.75)));
  EXPECT_EQ(map.pose().z, 3.0);
}

OccupancyMap mapOfCells(std::size_t width, std::size_t height, std::size_t cell_count) {
  return {width, height, 0.5, {}, std::vector<Cell>(cell_count)};
}

TEST(OccupancyMap, HasAtLeastACell) {
  EXPECT_THAT(test::messagesOf([] { mapOfCells(0, 4, 0); }),
              testing::ElementsAre(HasSubstr("found a map of 0 x 4 cells; it should have 1 to")));
  EXPECT_EQ(mapOfCells(1, 1, 1).cell(0, 0), kFree);
}

TEST(OccupancyMap, HasAsManyCellsAsItsSidesSay) {
  EXPECT_THAT(test::messagesOf([] { mapOfCells(3, 2, 5); }),
              testing::ElementsAre(HasSubstr("found 5 cells of a map of 3 x 2 cells")));
  EXPECT_THAT(test::messagesOf([] { mapOfCells(std::size_t{1} << 32U, std::size_t{1} << 32U, 0); }),
              testing::ElementsAre(HasSubstr("a side")));
}

TEST(OccupancyMap, HasCellsOfASizeAndAPlace) {
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_THAT(test::messagesOf([] { OccupancyMap(1, 1, 0.0, {}, {kFree}); }),
              testing::ElementsAre(HasSubstr("found a resolution of 0.0 m")));
  EXPECT_THAT(test::messagesOf([&] { OccupancyMap(1, 1, infinite, {}, {kFree}); }),
              testing::Not(testing::IsEmpty()));
  EXPECT_THAT(test::messagesOf([&] {
                OccupancyMap(1, 1, 0.5, {0.0, infinite, 0.0, 0.0}, {kFree});
              }),
              testing::ElementsAre(HasSubstr("found a map pose that is not finite")));
}

}  // namespace occupancy_map_test
}  // namespace synthetic_dataset::randomize

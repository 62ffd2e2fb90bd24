#include "randomize/placement/free_places.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

namespace synthetic_dataset::randomize {
namespace free_places_test {

using base::RandomSource;
using Eigen::Vector2d;

constexpr int kTries = 1000;

/// A map drawn in rows from the top: '.' free, '#' occupied, '?' unknown; cells of 0.5 m.
OccupancyMap drawn(const std::vector<std::string>& rows, const MapPose& X_GM = {}) {
  std::vector<Cell> cells;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char cell : *row) {
      cells.push_back(cell == '.' ? Cell::kFree : cell == '#' ? Cell::kOccupied : Cell::kUnknown);
    }
  }
  return {rows.front().size(), rows.size(), 0.5, X_GM, cells};
}

OccupancyMap hall(std::size_t width, std::size_t height) {
  return drawn(std::vector<std::string>(height, std::string(width, '.')));
}

/// 60 x 40 cells of 0.2 m, one in thirty of which is not free, turned and moved.
OccupancyMap clutteredMap() {
  constexpr std::size_t kWidth = 60;
  constexpr std::size_t kHeight = 40;
  RandomSource random(11);
  std::vector<Cell> cells(kWidth * kHeight, Cell::kFree);
  for (Cell& cell : cells) {
    if (random.index(30) == 0) cell = random.index(2) == 0 ? Cell::kOccupied : Cell::kUnknown;
  }
  return {kWidth, kHeight, 0.2, {3.0, -7.0, 0.0, 0.6}, cells};
}

constexpr double kClutteredRadius = 0.47;  // [m]: 2.35 cells

/// The distance from a place to the nearest cell that is not free or outside of the map [m], by
/// checking each cell.
double clearanceAt(const OccupancyMap& map, const Vector2d& p_G) {
  const double sine = std::sin(map.pose().yaw);
  const double cosine = std::cos(map.pose().yaw);
  const double across = p_G.x() - map.pose().x;
  const double up = p_G.y() - map.pose().y;
  const double x = (cosine * across + sine * up) / map.resolution();  // [cells]
  const double y = (cosine * up - sine * across) / map.resolution();
  double least =
      std::min({x, y, static_cast<double>(map.width()) - x, static_cast<double>(map.height()) - y});
  for (std::size_t row = 0; row < map.height(); ++row) {
    for (std::size_t column = 0; column < map.width(); ++column) {
      if (map.cell(column, row) == Cell::kFree) continue;
      const auto left = static_cast<double>(column);
      const auto below = static_cast<double>(row);
      least = std::min(least, std::hypot(x - std::clamp(x, left, left + 1.0),
                                         y - std::clamp(y, below, below + 1.0)));
    }
  }
  return least * map.resolution();
}

/// Any place in the map, free or not.
Vector2d anyPlace(const OccupancyMap& map, RandomSource& random) {
  const double x = random.uniform(0.0, static_cast<double>(map.width()) * map.resolution());
  const double y = random.uniform(0.0, static_cast<double>(map.height()) * map.resolution());
  return map.toGlobal({x, y});
}

/// How far counts are from being equal: for k counts, about k - 1, give or take a few times
/// sqrt(2 k).
double chiSquared(const std::vector<int>& counts, double expected) {
  double sum = 0.0;
  for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

TEST(FreePlaces, AreNeverNearerThanTheSafetyRadius) {
  const OccupancyMap map = clutteredMap();
  const FreePlaces places(map, kClutteredRadius);
  RandomSource random(1);
  double least = std::numeric_limits<double>::max();
  for (int i = 0; i < 4000; ++i) {
    const auto place = places.draw(random, kTries);
    ASSERT_TRUE(place);
    least = std::min(least, clearanceAt(map, *place));
  }
  EXPECT_GE(least, kClutteredRadius - 1e-9);
  // They do not keep a greater distance either.
  EXPECT_LT(least, kClutteredRadius + 0.005);
}

TEST(FreePlaces, AreAllThatAreClear) {
  const OccupancyMap map = clutteredMap();
  const FreePlaces places(map, kClutteredRadius);
  RandomSource random(2);
  int clear_count = 0;
  for (int i = 0; i < 10000; ++i) {
    const Vector2d place = anyPlace(map, random);
    const double clearance = clearanceAt(map, place);
    ASSERT_EQ(places.isClear(place), clearance >= kClutteredRadius) << clearance;
    clear_count += clearance >= kClutteredRadius ? 1 : 0;
  }
  EXPECT_GT(clear_count, 1000);
}

TEST(FreePlaces, AreDrawnEvenlyOverAHall) {
  // A disc of 2.5 cells in a hall of 20 x 10 cells has its centre in 15 x 5 of them, half a cell
  // beside the map's.
  const FreePlaces places(hall(20, 10), 1.25);
  RandomSource random(3);
  constexpr int kDraws = 60000;
  std::vector<int> counts(75, 0);
  for (int i = 0; i < kDraws; ++i) {
    const Vector2d place = places.draw(random, kTries).value() / 0.5;
    const auto column = static_cast<std::size_t>(place.x() - 2.5);
    const auto row = static_cast<std::size_t>(place.y() - 2.5);
    ++counts.at(row * 15 + column);
  }
  // 74 degrees of freedom: 74 with a deviation of sqrt(148) = 12.2. Even draws are beyond four
  // deviations once in some ten thousand seeds.
  EXPECT_LT(chiSquared(counts, kDraws / 75.0), 74.0 + 4.0 * 12.2);
  EXPECT_GT(chiSquared(counts, kDraws / 75.0), 74.0 - 4.0 * 12.2);
}

/// How many of the places that a source gives lie in each of 6 x 4 parts of the cluttered map.
std::vector<int> partsOf(const OccupancyMap& map, int count,
                         const std::function<Vector2d()>& next) {
  std::vector<int> counts(24, 0);
  for (int i = 0; i < count; ++i) {
    const Vector2d part = map.toMap(next()) / (10.0 * map.resolution());
    const auto row = static_cast<std::size_t>(part.y());
    ++counts.at(row * 6 + static_cast<std::size_t>(part.x()));
  }
  return counts;
}

TEST(FreePlaces, AreDrawnEvenlyAmongClutter) {
  const OccupancyMap map = clutteredMap();
  const FreePlaces places(map, kClutteredRadius);
  RandomSource random(4);
  constexpr int kDraws = 6000;
  const auto drawnPlace = [&] { return places.draw(random, kTries).value(); };
  const auto keptPlace = [&] {
    while (true) {
      const Vector2d place = anyPlace(map, random);
      if (clearanceAt(map, place) >= kClutteredRadius) return place;
    }
  };
  const std::vector<int> drawn_counts = partsOf(map, kDraws, drawnPlace);
  const std::vector<int> kept_counts = partsOf(map, kDraws, keptPlace);
  // Two samples of the same size from one distribution: the squares of the differences, each by its
  // variance, sum to 23 (one less than the parts) with a deviation of sqrt(46) = 6.8.
  double sum = 0.0;
  for (std::size_t i = 0; i < drawn_counts.size(); ++i) {
    const double difference = drawn_counts[i] - kept_counts[i];
    const double variance = drawn_counts[i] + kept_counts[i];
    ASSERT_GT(variance, 20.0);
    sum += difference * difference / variance;
  }
  EXPECT_LT(sum, 23.0 + 4.0 * 6.8);
}

TEST(FreePlaces, HardlyEverNeedASecondTry) {
  const FreePlaces places(hall(200, 200), 1.3);
  RandomSource random(5);
  int successes = 0;
  for (int i = 0; i < 1000; ++i) successes += places.draw(random, 1) ? 1 : 0;
  EXPECT_GT(successes, 980);
}

TEST(FreePlaces, AreTheSameForTheSameSeed) {
  const FreePlaces places(clutteredMap(), kClutteredRadius);
  RandomSource one(6);
  RandomSource other(6);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(places.draw(one, kTries), places.draw(other, kTries));
}

TEST(FreePlaces, LieWithinANarrowPassage) {
  // 5 cells (2.5 m) wide: a disc with a radius of 1.2 m has a range of 0.1 m.
  const OccupancyMap map = drawn({
      "############",
      "............",
      "............",
      "............",
      "............",
      "............",
      "############",
  });
  const FreePlaces places(map, 1.2);
  RandomSource random(7);
  for (int i = 0; i < 100; ++i) {
    const Vector2d place = places.draw(random, kTries).value();
    EXPECT_NEAR(place.y(), 1.75, 0.05);
    EXPECT_GE(place.x(), 1.2);
    EXPECT_LE(place.x(), 4.8);
  }
}

TEST(FreePlaces, AreNoneInAMapThatIsNotFree) {
  const FreePlaces places(drawn({"#?#", "???"}), 0.1);
  RandomSource random(8);
  EXPECT_EQ(places.cellCount(), 0U);
  EXPECT_EQ(places.draw(random, kTries), std::nullopt);
}

TEST(FreePlaces, AreNoneForADiscLargerThanTheMap) {
  RandomSource random(9);
  for (const double radius : {2.6, 100.0, 1e300}) {
    const FreePlaces places(hall(10, 10), radius);
    EXPECT_EQ(places.cellCount(), 0U) << radius;
    EXPECT_EQ(places.draw(random, kTries), std::nullopt) << radius;
    EXPECT_FALSE(places.isClear({2.5, 2.5})) << radius;
  }
}

TEST(FreePlaces, AreGivenUpAfterSomeTries) {
  // The centre of a disc of 2.5 m in a hall of 5 m x 5 m has one place, which chance never hits.
  const FreePlaces places(hall(10, 10), 2.5);
  RandomSource random(10);
  EXPECT_TRUE(places.isClear({2.5, 2.5}));
  EXPECT_GT(places.cellCount(), 0U);
  EXPECT_EQ(places.draw(random, kTries), std::nullopt);
}

TEST(FreePlaces, OfAPointAreAllFreeCells) {
  const OccupancyMap map = drawn({"..#?.", "#...."}, {5.0, 6.0, 0.0, -2.0});
  const FreePlaces places(map, 0.0);
  EXPECT_EQ(places.cellCount(), 7U);
  EXPECT_TRUE(places.isClear(map.toGlobal({0.75, 0.75})));
  EXPECT_FALSE(places.isClear(map.toGlobal({1.25, 0.75})));
  RandomSource random(12);
  constexpr int kDraws = 7000;
  std::vector<int> counts(10, 0);
  for (int i = 0; i < kDraws; ++i) {
    const Vector2d place = places.draw(random, 1).value();
    ASSERT_TRUE(map.isFree(place));
    const Vector2d cell = map.toMap(place) / 0.5;
    ++counts.at(static_cast<std::size_t>(cell.y()) * 5 + static_cast<std::size_t>(cell.x()));
  }
  counts.erase(std::remove(counts.begin(), counts.end(), 0), counts.end());
  ASSERT_EQ(counts.size(), 7U);
  // 6 degrees of freedom: above 27.9 once in ten thousand seeds.
  EXPECT_LT(chiSquared(counts, kDraws / 7.0), 27.9);
}

TEST(FreePlaces, MayTouchWhatIsNotFree) {
  // The occupied cell begins at x = 1.5 m.
  const FreePlaces places(drawn({"......", "...#..", "......"}), 0.25);
  EXPECT_TRUE(places.isClear({1.25, 0.75}));
  EXPECT_FALSE(places.isClear({1.2501, 0.75}));
  EXPECT_TRUE(places.isClear({0.25, 0.75}));
  EXPECT_FALSE(places.isClear({0.2499, 0.75}));
}

TEST(FreePlaces, GoAroundCorners) {
  // The occupied cell's corner is at (1.5, 0.5): a disc of 0.25 m may come nearer to it along each
  // axis than its radius, but not along both.
  const FreePlaces places(drawn({"......", "...#..", "......"}), 0.25);
  EXPECT_TRUE(places.isClear({1.5 - 0.18, 0.5 - 0.18}));
  EXPECT_FALSE(places.isClear({1.5 - 0.17, 0.5 - 0.17}));
}

TEST(LargestClearance, IsHalfTheWidthOfAHall) {
  EXPECT_DOUBLE_EQ(largestClearance(hall(10, 6)), 1.5);
  EXPECT_DOUBLE_EQ(largestClearance(hall(9, 5)), 1.25);
  EXPECT_DOUBLE_EQ(largestClearance(hall(1, 1)), 0.25);
}

TEST(LargestClearance, IsNothingWithoutAFreeCell) {
  EXPECT_EQ(largestClearance(drawn({"#?"})), 0.0);
}

TEST(LargestClearance, IsKeptFromUnknownCells) {
  // Halves of 4 x 4 cells on either side of the wall.
  EXPECT_DOUBLE_EQ(largestClearance(drawn({"....?....", "....?....", "....?....", "....?...."})),
                   1.0);
}

TEST(LargestClearance, IsThatOfADiscThatFits) {
  const OccupancyMap map = clutteredMap();
  const double largest = largestClearance(map);
  RandomSource random(13);
  EXPECT_GT(FreePlaces(map, 0.99 * largest).cellCount(), 0U);
  EXPECT_NE(FreePlaces(map, 0.95 * largest).draw(random, 100 * kTries), std::nullopt);
  EXPECT_EQ(FreePlaces(map, largest + map.resolution()).draw(random, 100 * kTries), std::nullopt);
}

}  // namespace free_places_test
}  // namespace synthetic_dataset::randomize

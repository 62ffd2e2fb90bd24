#include "base/random/random_source.h"

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace synthetic_dataset::base {
namespace random_source_test {

constexpr int kDraws = 100000;
constexpr double kPi = 3.141592653589793;

/// How far counts are from being equal: for k counts, k - 1 give or take a few times sqrt(2 k).
double chiSquared(const std::vector<int>& counts, double expected) {
  double sum = 0.0;
  for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

TEST(RandomSource, GivesTheSameNumbersOnEveryMachine) {
  // The first outputs of SplitMix64 for the seed 1234567, as its authors' code gives them.
  RandomSource source(1234567);
  EXPECT_EQ(source.bits(), 6457827717110365317ULL);
  EXPECT_EQ(source.bits(), 3203168211198807973ULL);
}

TEST(RandomSource, SpreadsNumbersEvenly) {
  RandomSource source(3);
  std::vector<int> counts(100, 0);
  for (int i = 0; i < kDraws; ++i) {
    const double number = source.unit();
    ASSERT_GE(number, 0.0);
    ASSERT_LT(number, 1.0);
    ++counts[static_cast<std::size_t>(number * 100.0)];
  }
  EXPECT_LT(chiSquared(counts, kDraws / 100.0), 160.0);
  EXPECT_GT(chiSquared(counts, kDraws / 100.0), 50.0);
}

TEST(RandomSource, ChoosesEachPlaceAsOften) {
  RandomSource source(4);
  std::vector<int> counts(7, 0);
  for (int i = 0; i < kDraws; ++i) ++counts.at(source.index(7));
  EXPECT_LT(chiSquared(counts, kDraws / 7.0), 24.0);
  EXPECT_EQ(RandomSource(4).index(1), 0U);
}

TEST(RandomSource, NormalNumbersHaveMeanZeroAndDeviationOne) {
  RandomSource source(5);
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = source.normal();
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 4.0 / std::sqrt(kDraws));
  EXPECT_NEAR(squares / kDraws, 1.0, 4.0 * std::sqrt(2.0 / kDraws));
}

TEST(RandomSource, HeadingsFillTheCircle) {
  RandomSource source(6);
  std::vector<int> counts(36, 0);
  for (int i = 0; i < kDraws; ++i) {
    const double angle = source.angle();
    ASSERT_GT(angle, -kPi);
    ASSERT_LE(angle, kPi);
    ++counts[std::min<std::size_t>(35, static_cast<std::size_t>((angle + kPi) / kPi * 18.0))];
  }
  EXPECT_LT(chiSquared(counts, kDraws / 36.0), 74.0);
}

TEST(RandomSource, DirectionsFillTheSphere) {
  RandomSource source(7);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  for (int i = 0; i < kDraws; ++i) {
    const Eigen::Vector3d direction = source.direction();
    ASSERT_NEAR(direction.norm(), 1.0, 1e-12);
    sum += direction;
    products += direction * direction.transpose();
  }
  EXPECT_LT((sum / kDraws).norm(), 0.01);
  EXPECT_LT((products / kDraws - Eigen::Matrix3d::Identity() / 3.0).norm(), 0.01);
}

TEST(RandomSource, OrientationsFillTheGroupOfRotations) {
  // The angles of uniform rotations have the density (1 - cos angle) / pi and the mean
  // pi / 2 + 2 / pi, and any vector is turned into all directions alike.
  RandomSource source(8);
  double angles = 0.0;
  Eigen::Vector3d turned = Eigen::Vector3d::Zero();
  for (int i = 0; i < kDraws; ++i) {
    const auto orientation = source.orientation();
    ASSERT_NEAR(orientation.norm(), 1.0, 1e-12);
    angles += Eigen::AngleAxisd(orientation.toRotationMatrix()).angle();
    turned += orientation.toRotationMatrix() * Eigen::Vector3d::UnitX();
  }
  EXPECT_NEAR(angles / kDraws, kPi / 2.0 + 2.0 / kPi, 0.01);
  EXPECT_LT((turned / kDraws).norm(), 0.01);
}

/// Drawing 2 of 6 things: each ordered pair comes as often as the others.
TEST(RandomSource, ChoosesEachPairAsOften) {
  RandomSource source(5);
  std::map<std::pair<std::size_t, std::size_t>, int> counts;
  constexpr int kPairs = 30000;
  for (int i = 0; i < kPairs; ++i) {
    const std::vector<std::size_t> chosen = source.choice(2, 6);
    ASSERT_EQ(chosen.size(), 2U);
    ASSERT_NE(chosen[0], chosen[1]);
    ++counts[{chosen[0], chosen[1]}];
  }
  EXPECT_EQ(counts.size(), 30U);
  for (const auto& [pair, count] : counts) EXPECT_NEAR(count, kPairs / 30, 160);
  EXPECT_TRUE(source.choice(0, 3).empty());
}

}  // namespace random_source_test
}  // namespace synthetic_dataset::base

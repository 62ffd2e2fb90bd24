#include <cmath>

#include <gtest/gtest.h>

#include "base/random/random_seed.h"

namespace synthetic_dataset::base {
namespace random_normal_test {

constexpr int kDraws = 100000;

TEST(RandomNormal, HasTheMomentsOfTheNormalDistribution) {
  double sum = 0.0;
  double squares = 0.0;
  double fourths = 0.0;
  double products = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const NormalPair pair = randomNormals(5, static_cast<std::uint64_t>(i));
    for (const double x : {pair.first, pair.second}) {
      sum += x;
      squares += x * x;
      fourths += x * x * x * x;
    }
    products += pair.first * pair.second;
  }
  const double n = 2.0 * kDraws;
  // Four standard errors: 1 / sqrt(n), sqrt(2 / n), sqrt(96 / n), 1 / sqrt(n / 2).
  EXPECT_NEAR(sum / n, 0.0, 4.0 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 1.0, 4.0 * std::sqrt(2.0 / n));
  EXPECT_NEAR(fourths / n, 3.0, 4.0 * std::sqrt(96.0 / n));
  EXPECT_NEAR(products / kDraws, 0.0, 4.0 / std::sqrt(kDraws));
}

TEST(RandomNormal, NeighboursAndOtherSeedsAreUncorrelated) {
  double neighbours = 0.0;
  double seeds = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const auto place = static_cast<std::uint64_t>(i);
    neighbours += randomNormals(5, place).first * randomNormals(5, place + 1).first;
    seeds += randomNormals(5, place).first * randomNormals(6, place).first;
  }
  EXPECT_NEAR(neighbours / kDraws, 0.0, 4.0 / std::sqrt(kDraws));
  EXPECT_NEAR(seeds / kDraws, 0.0, 4.0 / std::sqrt(kDraws));
}

}  // namespace random_normal_test
}  // namespace synthetic_dataset::base

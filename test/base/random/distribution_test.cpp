#include "base/random/distribution.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gmock/gmock.h>

#include "base/random/weighted_index.h"

namespace synthetic_dataset::base {
namespace distribution_test {

using ::testing::Each;
using ::testing::ElementsAre;

constexpr int kDraws = 100000;
constexpr double kPi = 3.141592653589793;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Moments {
  double mean = 0.0;
  double variance = 0.0;
  double least = kInfinity;
  double greatest = -kInfinity;
};

Moments momentsOf(const Distribution& distribution, std::uint64_t seed) {
  RandomSource source(seed);
  Moments moments;
  for (int i = 0; i < kDraws; ++i) {
    const double x = distribution.drawNumber(source);
    moments.mean += x / kDraws;
    moments.variance += x * x / kDraws;
    moments.least = std::min(moments.least, x);
    moments.greatest = std::max(moments.greatest, x);
  }
  moments.variance -= moments.mean * moments.mean;
  return moments;
}

/// How far counts are from those expected: for k counts, k - 1 give or take a few times sqrt(2 k).
double chiSquared(const std::vector<int>& counts, const std::vector<double>& shares) {
  double sum = 0.0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double expected = shares[i] * kDraws;
    sum += (counts[i] - expected) * (counts[i] - expected) / expected;
  }
  return sum;
}

TEST(Distribution, AConstantIsItself) {
  RandomSource source(1);
  const Distribution colour = Distribution::constant({0.1, 0.2, 0.3});
  EXPECT_THAT(colour.draw(source), ElementsAre(0.1, 0.2, 0.3));
  EXPECT_EQ(colour.dimension(), 3U);
  EXPECT_EQ(colour.lowest(), 0.1);
  EXPECT_EQ(colour.highest(), 0.3);
  EXPECT_EQ(Distribution::constant({7.0}).drawNumber(source), 7.0);
}

TEST(Distribution, UniformFillsItsRange) {
  const Distribution distribution = Distribution::uniform({2.0}, {5.0});
  const Moments moments = momentsOf(distribution, 2);
  EXPECT_NEAR(moments.mean, 3.5, 4.0 * std::sqrt(0.75 / kDraws));
  EXPECT_NEAR(moments.variance, 0.75, 0.01);
  EXPECT_GE(moments.least, 2.0);
  EXPECT_LE(moments.greatest, 5.0);
  EXPECT_NEAR(moments.least, 2.0, 1e-3);
  EXPECT_NEAR(moments.greatest, 5.0, 1e-3);
  EXPECT_EQ(distribution.lowest(), 2.0);
  EXPECT_EQ(distribution.highest(), 5.0);
}

TEST(Distribution, UniformOfOneNumberIsThatNumber) {
  RandomSource source(3);
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(Distribution::uniform({0.1}, {0.1}).drawNumber(source), 0.1);
    EXPECT_EQ(Distribution::logUniform({0.1}, {0.1}).drawNumber(source), 0.1);
  }
}

TEST(Distribution, LogUniformHasAsManyInEachDecade) {
  const Distribution distribution = Distribution::logUniform({0.01}, {100.0});
  RandomSource source(4);
  std::vector<int> counts(4, 0);
  for (int i = 0; i < kDraws; ++i) {
    const double number = distribution.drawNumber(source);
    ASSERT_GE(number, 0.01);
    ASSERT_LE(number, 100.0);
    ++counts[std::min<std::size_t>(3, static_cast<std::size_t>(std::log10(number) + 2.0))];
  }
  EXPECT_LT(chiSquared(counts, {0.25, 0.25, 0.25, 0.25}), 16.0);
  EXPECT_EQ(distribution.lowest(), 0.01);
  EXPECT_EQ(distribution.highest(), 100.0);
}

TEST(Distribution, NormalHasItsMeanAndDeviation) {
  const Distribution distribution = Distribution::normal({10.0}, {2.0});
  const Moments moments = momentsOf(distribution, 5);
  EXPECT_NEAR(moments.mean, 10.0, 4.0 * 2.0 / std::sqrt(kDraws));
  EXPECT_NEAR(moments.variance, 4.0, 4.0 * 4.0 * std::sqrt(2.0 / kDraws));
  EXPECT_EQ(distribution.lowest(), -kInfinity);
  EXPECT_EQ(distribution.highest(), kInfinity);
}

TEST(Distribution, NormalIsDrawnAnewBeyondItsBounds) {
  // A half-normal distribution, with mean sqrt(2 / pi), variance 1 - 2 / pi and no values piled up
  // at its bound.
  const Distribution distribution = Distribution::normalBetween({0.0}, {1.0}, {0.0}, {kInfinity});
  const Moments moments = momentsOf(distribution, 6);
  EXPECT_GT(moments.least, 0.0);
  EXPECT_NEAR(moments.mean, std::sqrt(2.0 / kPi), 0.01);
  EXPECT_NEAR(moments.variance, 1.0 - 2.0 / kPi, 0.01);
  EXPECT_EQ(distribution.lowest(), 0.0);
  EXPECT_EQ(distribution.highest(), kInfinity);
}

TEST(Distribution, NormalThatNeverMeetsItsBoundsTakesTheNearer) {
  RandomSource source(7);
  EXPECT_EQ(Distribution::normalBetween({0.0}, {1.0}, {50.0}, {60.0}).drawNumber(source), 50.0);
  EXPECT_EQ(Distribution::normalBetween({0.0}, {1.0}, {-60.0}, {-50.0}).drawNumber(source), -50.0);
  EXPECT_EQ(Distribution::normal({3.0}, {0.0}).drawNumber(source), 3.0);
}

TEST(Distribution, AChoiceTakesEachValueAsOften) {
  const Distribution distribution = Distribution::choice({{5.0}, {7.0}, {6.0}});
  RandomSource source(8);
  std::vector<int> counts(3, 0);
  for (int i = 0; i < kDraws; ++i) {
    ++counts.at(static_cast<std::size_t>(distribution.drawNumber(source)) - 5);
  }
  EXPECT_LT(chiSquared(counts, {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0}), 14.0);
  EXPECT_EQ(distribution.lowest(), 5.0);
  EXPECT_EQ(distribution.highest(), 7.0);
}

TEST(Distribution, AChoiceTakesEachValueAsItsWeightSays) {
  const Distribution distribution =
      Distribution::choice({{0.0}, {1.0}, {2.0}, {3.0}, {4.0}}, {2.0, 0.0, 5.0, 3.0, 0.0});
  RandomSource source(9);
  std::vector<int> counts(5, 0);
  for (int i = 0; i < kDraws; ++i) {
    ++counts.at(static_cast<std::size_t>(distribution.drawNumber(source)));
  }
  EXPECT_EQ(counts[1], 0);
  EXPECT_EQ(counts[4], 0);
  EXPECT_LT(chiSquared({counts[0], counts[2], counts[3]}, {0.2, 0.5, 0.3}), 14.0);
}

TEST(Distribution, AChoiceNeverTakesAValueOfNoWeight) {
  // A random fraction of so small a weight is rounded up to the whole weight in half of all draws.
  constexpr double kLeast = std::numeric_limits<double>::denorm_min();
  const Distribution distribution = Distribution::choice({{1.0}, {2.0}}, {kLeast, 0.0});
  RandomSource source(18);
  for (int i = 0; i < 100; ++i) ASSERT_EQ(distribution.drawNumber(source), 1.0);
}

TEST(Distribution, AChoiceAmongVectorsKeepsThemWhole) {
  const Distribution distribution = Distribution::choice({{1.0, 2.0}, {3.0, 4.0}});
  RandomSource source(10);
  for (int i = 0; i < 100; ++i) {
    const std::vector<double> drawn = distribution.draw(source);
    ASSERT_EQ(drawn[1], drawn[0] + 1.0);
  }
  EXPECT_EQ(distribution.dimension(), 2U);
  EXPECT_EQ(distribution.lowest(), 1.0);
  EXPECT_EQ(distribution.highest(), 4.0);
}

TEST(Distribution, OneDrawServesAllComponentsOfSingleNumbers) {
  for (const Distribution& grey :
       {Distribution::uniform({0.0}, {1.0}, 3), Distribution::logUniform({0.1}, {1.0}, 3),
        Distribution::normal({0.5}, {0.1}, 3)}) {
    RandomSource source(11);
    for (int i = 0; i < 100; ++i) {
      const std::vector<double> drawn = grey.draw(source);
      ASSERT_EQ(drawn.size(), 3U);
      ASSERT_THAT(drawn, Each(drawn.front()));
    }
  }
}

/// The correlation of the first two components.
double correlationOf(const Distribution& distribution) {
  RandomSource source(12);
  double first = 0.0;
  double second = 0.0;
  double products = 0.0;
  double squares = 0.0;
  double other_squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const std::vector<double> drawn = distribution.draw(source);
    first += drawn[0] / kDraws;
    second += drawn[1] / kDraws;
    products += drawn[0] * drawn[1] / kDraws;
    squares += drawn[0] * drawn[0] / kDraws;
    other_squares += drawn[1] * drawn[1] / kDraws;
  }
  return (products - first * second) /
         std::sqrt((squares - first * first) * (other_squares - second * second));
}

TEST(Distribution, EachComponentIsDrawnOnItsOwnWhereOneHasNumbersOfItsOwn) {
  EXPECT_NEAR(correlationOf(Distribution::uniform({0.0}, {1.0}, 2)), 1.0, 1e-9);
  for (const Distribution& colour :
       {Distribution::uniform({0.0}, {1.0, 1.0}, 2), Distribution::uniform({0.0, 0.0}, {1.0}, 2),
        Distribution::logUniform({0.1}, {1.0, 1.0}, 2),
        Distribution::logUniform({0.1, 0.1}, {1.0}, 2), Distribution::normal({0.5, 0.5}, {0.1}, 2),
        Distribution::normal({0.5}, {0.1, 0.1}, 2),
        Distribution::normalBetween({0.5}, {0.1}, {0.0, 0.0}, {1.0}, 2),
        Distribution::normalBetween({0.5}, {0.1}, {0.0}, {1.0, 1.0}, 2)}) {
    EXPECT_NEAR(correlationOf(colour), 0.0, 0.02);
  }
}

TEST(Distribution, EachComponentHasItsOwnRange) {
  const Distribution distribution = Distribution::uniform({0.0, 10.0, 5.0}, {1.0, 20.0, 5.0}, 3);
  RandomSource source(13);
  for (int i = 0; i < 1000; ++i) {
    const std::vector<double> drawn = distribution.draw(source);
    ASSERT_TRUE(drawn[0] >= 0.0 && drawn[0] <= 1.0);
    ASSERT_TRUE(drawn[1] >= 10.0 && drawn[1] <= 20.0);
    ASSERT_EQ(drawn[2], 5.0);
  }
  EXPECT_EQ(distribution.lowest(), 0.0);
  EXPECT_EQ(distribution.highest(), 20.0);
}

TEST(Distribution, TheSameSeedGivesTheSameDraws) {
  const std::vector<Distribution> all = {
      Distribution::uniform({0.0}, {1.0, 2.0}, 2), Distribution::logUniform({1.0}, {2.0}),
      Distribution::normalBetween({0.0}, {1.0}, {0.5}, {9.0}),
      Distribution::choice({{1.0}, {2.0}, {3.0}}, {1.0, 2.0, 3.0})};
  RandomSource first(14);
  RandomSource second(14);
  RandomSource other(15);
  for (const Distribution& each : all) {
    const std::vector<double> drawn = each.draw(first);
    EXPECT_EQ(drawn, each.draw(second));
  }
  EXPECT_EQ(first.bits(), second.bits());
  EXPECT_NE(all[0].draw(first), all[0].draw(other));
}

TEST(TextChoice, DrawsEachTextAsItsWeightSays) {
  const TextChoice choice{{"oak", "pine", "birch"}, {1.0, 0.0, 3.0}};
  RandomSource source(16);
  std::vector<int> counts(2, 0);
  for (int i = 0; i < kDraws; ++i) {
    const std::string& drawn = choice.draw(source);
    ASSERT_NE(drawn, "pine");
    ++counts[drawn == "oak" ? 0 : 1];
  }
  EXPECT_LT(chiSquared(counts, {0.25, 0.75}), 11.0);
}

TEST(TextChoice, DrawsAllAlikeWithoutWeights) {
  const TextChoice choice{{"oak", "pine"}, {}};
  RandomSource source(17);
  std::vector<int> counts(2, 0);
  for (int i = 0; i < kDraws; ++i) ++counts[choice.draw(source) == "oak" ? 0 : 1];
  EXPECT_LT(chiSquared(counts, {0.5, 0.5}), 11.0);
}

TEST(Distribution, ListsTheValuesOfAChoice) {
  EXPECT_THAT(Distribution::choice({{3.0}, {1.0}}, {1.0, 0.0}).values(),
              ElementsAre(ElementsAre(3.0), ElementsAre(1.0)));
  EXPECT_THAT(Distribution::constant({2.0}).values(), ElementsAre(ElementsAre(2.0)));
  EXPECT_THAT(Distribution::uniform({1.0}, {2.0}).values(), testing::IsEmpty());
}

}  // namespace distribution_test
}  // namespace synthetic_dataset::base

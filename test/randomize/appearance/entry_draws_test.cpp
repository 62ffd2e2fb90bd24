#include "randomize/appearance/entry_draws.h"

#include <cmath>
#include <set>

#include <gmock/gmock.h>

namespace synthetic_dataset::randomize {
namespace entry_draws_test {

using base::Distribution;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

const Distribution kUnit = Distribution::uniform({0.0}, {1.0});
const Distribution kColour = Distribution::uniform({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, 3);

TEST(EntryDraws, DrawNothingWhereThereIsNoEntry) {
  EntryDraws draws(1, 0);
  EXPECT_FALSE(draws.number("a", std::nullopt));
  EXPECT_FALSE(draws.vector("b", std::nullopt));
  EXPECT_THAT(draws.values(), IsEmpty());
}

TEST(EntryDraws, OfAnEntryAreTheSameWhateverElseIsDrawn) {
  EntryDraws alone(1, 5);
  const auto number = alone.number("lights/sun/intensity", kUnit);
  const auto colour = EntryDraws(1, 5).vector("ambient", kColour);

  EntryDraws among_others(1, 5);
  EXPECT_EQ(among_others.vector("ambient", kColour), colour);
  (void)among_others.number("lights/sun/azimuth", kUnit);
  (void)among_others.happens("lights/sun/present", 0.5);
  EXPECT_EQ(among_others.number("lights/sun/intensity", kUnit), number);
}

TEST(EntryDraws, DifferFromSeedToSeedSceneToSceneNameToNameAndOwnerToOwner) {
  const std::set<double> drawn = {
      *EntryDraws(1, 5).number("a", kUnit),         *EntryDraws(2, 5).number("a", kUnit),
      *EntryDraws(1, 6).number("a", kUnit),         *EntryDraws(1, 5).number("b", kUnit),
      *EntryDraws(1, 5, "left").number("a", kUnit), *EntryDraws(1, 5, "right").number("a", kUnit)};
  EXPECT_EQ(drawn.size(), 6U);
}

TEST(EntryDraws, AreThoseOfTheEntrysOwnSource) {
  EntryDraws draws(1, 5, "left");
  base::RandomSource source = draws.source("sensor/blur");
  EXPECT_EQ(draws.number("sensor/blur", kUnit), source.unit());
}

TEST(EntryDraws, AreSpreadOverTheScenes) {
  constexpr int kScenes = 2000;
  double sum = 0.0;
  double squares = 0.0;
  for (int scene = 0; scene < kScenes; ++scene) {
    const double number = *EntryDraws(1, scene).number("a", kUnit);
    sum += number;
    squares += number * number;
  }
  const double mean = sum / kScenes;
  EXPECT_NEAR(mean, 0.5, 0.03);
  EXPECT_NEAR(squares / kScenes - mean * mean, 1.0 / 12.0, 0.01);
}

TEST(EntryDraws, HappenAsOftenAsTheirProbabilitySays) {
  constexpr int kScenes = 2000;
  for (const double probability : {0.0, 0.2, 0.9, 1.0}) {
    int count = 0;
    for (int scene = 0; scene < kScenes; ++scene) {
      count += EntryDraws(3, scene).happens("lights/lamp/present", probability) ? 1 : 0;
    }
    const double spread = std::sqrt(kScenes * probability * (1.0 - probability));
    EXPECT_NEAR(count, kScenes * probability, 4.0 * spread) << probability;
  }
}

TEST(EntryDraws, AreKeptInTheOrderOfDrawing) {
  EntryDraws draws(1, 0);
  const double number = *draws.number("b", kUnit);
  const Eigen::Vector3d colour = *draws.vector("a", kColour);
  draws.note("textures", "dots");
  const bool is_on = draws.happens("present", 1.0);

  EXPECT_TRUE(is_on);
  const std::vector<DrawnValue>& values = draws.values();
  ASSERT_EQ(values.size(), 4U);
  EXPECT_EQ(values[0].name, "b") << "without its owner, which is its scene's";
  EXPECT_THAT(std::get<std::vector<double>>(values[0].value), ElementsAre(number));
  EXPECT_EQ(values[1].name, "a");
  EXPECT_THAT(std::get<std::vector<double>>(values[1].value),
              ElementsAre(colour[0], colour[1], colour[2]));
  EXPECT_EQ(values[2].name, "textures");
  EXPECT_EQ(std::get<std::string>(values[2].value), "dots");
  EXPECT_EQ(values[3].name, "present");
  EXPECT_THAT(std::get<std::vector<double>>(values[3].value), ElementsAre(1.0));
}

}  // namespace entry_draws_test
}  // namespace synthetic_dataset::randomize

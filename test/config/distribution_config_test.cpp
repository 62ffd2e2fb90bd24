#include "config/distribution_config.h"

#include <algorithm>

#include <gmock/gmock.h>

#include "base/yaml_value.h"

namespace synthetic_dataset::config {
namespace distribution_config_test {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Ge;
using ::testing::IsEmpty;
using ::testing::Le;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr DistributionRange kShare = {1, 0.0, 1.0};
constexpr DistributionRange kColour = {3, 0.0, 1.0};
constexpr DistributionRange kPosition = {3};
constexpr DistributionRange kEachAxis = {3, -kInfinity, kInfinity, true};

/// Settings whose entry `sun/x` is this.
Parameters settings(const std::string& x) {
  return Parameters(base::parseYaml("sun: {x: " + x + "}", "test"));
}

/// Numbers drawn from an entry that should be valid.
std::vector<std::vector<double>> drawsOf(const std::string& x, const DistributionRange& range,
                                         int count = 100) {
  Parameters root = settings(x);
  const auto distribution = maybeDistribution(root.group("sun"), "x", range);
  EXPECT_THAT(root.errors(), IsEmpty()) << x;
  EXPECT_THAT(root.unknownNames(), IsEmpty()) << x;
  std::vector<std::vector<double>> draws;
  if (!distribution) return draws;
  EXPECT_EQ(distribution->dimension(), range.dimension) << x;
  base::RandomSource source(1);
  for (int i = 0; i < count; ++i) draws.push_back(distribution->draw(source));
  return draws;
}

/// The lowest and the highest value of an entry that should be valid.
std::pair<double, double> rangeOf(const std::string& x, const DistributionRange& range = {}) {
  Parameters root = settings(x);
  const auto distribution = maybeDistribution(root.group("sun"), "x", range);
  EXPECT_THAT(root.errors(), IsEmpty()) << x;
  if (!distribution) return {};
  return {distribution->lowest(), distribution->highest()};
}

/// The only error of an entry, without its name.
std::string errorOf(const std::string& x, const DistributionRange& range = {}) {
  Parameters root = settings(x);
  EXPECT_FALSE(maybeDistribution(root.group("sun"), "x", range)) << x;
  EXPECT_THAT(root.unknownNames(), IsEmpty()) << x;
  EXPECT_EQ(root.errors().size(), 1U) << x;
  if (root.errors().empty()) return "no error";
  const std::string& error = root.errors().front();
  EXPECT_EQ(error.substr(0, 7), "sun/x: ");
  return error.substr(7);
}

std::string choiceErrorOf(const std::string& x) {
  Parameters root = settings(x);
  EXPECT_FALSE(maybeChoice(root.group("sun"), "x")) << x;
  EXPECT_EQ(root.errors().size(), 1U) << x;
  return root.errors().empty() ? "no error" : root.errors().front().substr(7);
}

TEST(MaybeDistribution, IsNothingWhereNothingIsGiven) {
  Parameters root = settings("1");
  EXPECT_FALSE(maybeDistribution(root.group("sun"), "y"));
  EXPECT_THAT(root.errors(), IsEmpty());
}

TEST(MaybeDistribution, ANumberIsAConstant) {
  EXPECT_THAT(drawsOf("0.5", kShare), Each(ElementsAre(0.5)));
  EXPECT_THAT(drawsOf("1", kShare), Each(ElementsAre(1.0)));
  EXPECT_THAT(drawsOf("'1e-05'", kShare), Each(ElementsAre(1e-5)));
}

TEST(MaybeDistribution, AConstantVectorIsAListOrOneNumberForAll) {
  EXPECT_THAT(drawsOf("[0.1, 0.2, 1]", kColour), Each(ElementsAre(0.1, 0.2, 1.0)));
  EXPECT_THAT(drawsOf("0.5", kColour), Each(ElementsAre(0.5, 0.5, 0.5)));
}

TEST(MaybeDistribution, ReadsUniform) {
  EXPECT_EQ(rangeOf("{uniform: [2, 3.5]}"), std::make_pair(2.0, 3.5));
  EXPECT_EQ(rangeOf("{uniform: [0, 1]}", kShare), std::make_pair(0.0, 1.0));
  for (const auto& drawn : drawsOf("{uniform: [0, 1]}", kColour)) {
    EXPECT_THAT(drawn, Each(drawn[0])) << "one draw for all";
  }
  for (const auto& drawn : drawsOf("{uniform: [0, [1, 2, 3]]}", kPosition)) {
    EXPECT_NE(drawn[0], drawn[1]);
  }
}

TEST(MaybeDistribution, DrawsEachNumberOfAPlaceByItself) {
  for (const char* entry : {"{uniform: [0, 1]}", "{log_uniform: [1, 2]}", "{normal: [0, 1]}",
                            "{normal: [0, 1], min: -9, max: 9}", "{uniform: [0, [1, 1, 1]]}"}) {
    for (const auto& drawn : drawsOf(entry, kEachAxis)) {
      EXPECT_NE(drawn[0], drawn[1]) << entry;
      EXPECT_NE(drawn[1], drawn[2]) << entry;
      EXPECT_NE(drawn[0], drawn[2]) << entry;
    }
  }
}

TEST(MaybeDistribution, DrawsAPlaceFromTheSameRangeOnEachAxis) {
  double lowest = kInfinity;
  double highest = -kInfinity;
  for (const auto& drawn : drawsOf("{uniform: [-2, 3]}", kEachAxis, 300)) {
    EXPECT_THAT(drawn, Each(AllOf(Ge(-2.0), Le(3.0))));
    lowest = std::min(lowest, drawn[2]);
    highest = std::max(highest, drawn[2]);
  }
  EXPECT_LT(lowest, -1.9);
  EXPECT_GT(highest, 2.9);
}

TEST(MaybeDistribution, TakesOneNumberForAllOfAConstantPlace) {
  EXPECT_THAT(drawsOf("0.5", kEachAxis), Each(ElementsAre(0.5, 0.5, 0.5)));
  EXPECT_THAT(drawsOf("{choice: [4]}", kEachAxis), Each(ElementsAre(4.0, 4.0, 4.0)));
  EXPECT_THAT(drawsOf("{normal: [[1, 2, 3], 0]}", kEachAxis), Each(ElementsAre(1.0, 2.0, 3.0)));
}

TEST(MaybeDistribution, RefusesTheSameOfAPlace) {
  EXPECT_EQ(errorOf("{uniform: [3, 1]}", kEachAxis),
            "found uniform: [3, 1]; it should be [low, high], low not above high");
  EXPECT_EQ(errorOf("{normal: [5, 1], max: 4}", kEachAxis),
            "found normal: [5, 1], max: 4; it should be [mean, stddev], mean not below min and not "
            "above max");
}

TEST(MaybeDistribution, ReadsLogUniform) {
  EXPECT_EQ(rangeOf("{log_uniform: [0.1, 10]}"), std::make_pair(0.1, 10.0));
  int below = 0;
  for (const auto& drawn : drawsOf("{log_uniform: [0.001, 1000]}", {}, 1000)) {
    below += drawn[0] < 1.0 ? 1 : 0;
  }
  EXPECT_NEAR(below, 500, 80);
}

TEST(MaybeDistribution, ReadsNormal) {
  EXPECT_EQ(rangeOf("{normal: [0, 1]}"), std::make_pair(-kInfinity, kInfinity));
  EXPECT_EQ(rangeOf("{normal: [0, 1], min: null}"), std::make_pair(-kInfinity, kInfinity));
  EXPECT_EQ(rangeOf("{normal: [0, 1], max: 2}"), std::make_pair(-kInfinity, 2.0));
  EXPECT_EQ(rangeOf("{normal: [0.5, 1], min: 0.25}", kShare), std::make_pair(0.25, 1.0));
  EXPECT_THAT(drawsOf("{normal: [7, 0]}", {}), Each(ElementsAre(7.0)));
  EXPECT_THAT(drawsOf("{normal: [[1, 2, 3], 0], min: [1, 2, 3], max: 9}", kPosition),
              Each(ElementsAre(1.0, 2.0, 3.0)));
}

TEST(MaybeDistribution, CutsANormalOneAtTheRange) {
  EXPECT_EQ(rangeOf("{normal: [0.5, 1]}", kShare), std::make_pair(0.0, 1.0));
  EXPECT_THAT(drawsOf("{normal: [0.5, 1]}", kShare), Each(Each(AllOf(Ge(0.0), Le(1.0)))));
}

TEST(MaybeDistribution, ReadsAChoiceWithWeights) {
  EXPECT_EQ(rangeOf("{choice: [3, 1, 2.5]}"), std::make_pair(1.0, 3.0));
  EXPECT_THAT(drawsOf("{choice: [3, 4], weights: [0, 0.1]}", {}), Each(ElementsAre(4.0)));
  EXPECT_THAT(drawsOf("{choice: [[0, 0, 1], 0.5], weights: [1, 0]}", kColour),
              Each(ElementsAre(0.0, 0.0, 1.0)));
  EXPECT_THAT(drawsOf("{choice: [[0, 0, 1], 0.5], weights: [0, 1]}", kColour),
              Each(ElementsAre(0.5, 0.5, 0.5)));
}

TEST(MaybeDistribution, RefusesWhatIsNoNumber) {
  EXPECT_EQ(errorOf("bright"),
            "found bright (a text); it should be a number, or a group with uniform, log_uniform, "
            "normal or choice");
  EXPECT_EQ(errorOf("true"),
            "found True (a true/false value); it should be a number, or a group with uniform, "
            "log_uniform, normal or choice");
  EXPECT_EQ(errorOf(".inf"),
            "found inf (a number); it should be a number, or a group with uniform, log_uniform, "
            "normal or choice");
}

TEST(MaybeDistribution, RefusesAnotherDimension) {
  EXPECT_EQ(errorOf("[1, 2]", kColour),
            "found [1, 2] (a list); it should be a number or a list of 3, or a group with uniform, "
            "log_uniform, normal or choice");
  EXPECT_EQ(errorOf("[1]"),
            "found [1] (a list); it should be a number, or a group with uniform, log_uniform, "
            "normal or choice");
  EXPECT_EQ(errorOf("{uniform: [[0, 0], 1]}", kColour),
            "found uniform: [[0, 0], 1]; it should be [low, high], each a number or a list of 3");
  EXPECT_EQ(errorOf("{normal: [[0, 0], 1]}"),
            "found normal: [[0, 0], 1]; it should be [mean, stddev], each a number");
  EXPECT_EQ(errorOf("{normal: [0, 1], min: [0, 0]}"), "found min: [0, 0]; it should be a number");
  EXPECT_EQ(errorOf("{choice: [1, [1, 1]]}", kColour),
            "found [1, 1] in choice; it should be a number or a list of 3");
}

TEST(MaybeDistribution, RefusesGroupsOfNoKindOrTwo) {
  const std::string should = "it should be a group with uniform, log_uniform, normal or choice";
  EXPECT_EQ(errorOf("{}"), "found an empty group; " + should);
  EXPECT_EQ(errorOf("{normal: [0, 1], uniform: [0, 1]}"),
            "found uniform and normal at once; " + should);
  EXPECT_EQ(errorOf("{unifrom: [0, 1]}"),
            "found 'unifrom'; " + should + "; did you mean 'uniform'?");
  EXPECT_EQ(errorOf("{weights: [0, 1]}"), "found 'weights'; " + should);
}

TEST(MaybeDistribution, RefusesWhatDoesNotBelongBesideAKind) {
  EXPECT_EQ(errorOf("{uniform: [0, 1], min: 0}"),
            "found 'min' beside uniform; it should be uniform alone");
  EXPECT_EQ(errorOf("{choice: [0, 1], weight: [1, 1]}"),
            "found 'weight' beside choice; it should be choice with weights at most; did you mean "
            "'weights'?");
  EXPECT_EQ(errorOf("{normal: [0, 1], weights: [1, 1]}"),
            "found 'weights' beside normal; it should be normal with min and max at most");
}

TEST(MaybeDistribution, RefusesEndsThatAreNone) {
  const std::string should = "it should be [low, high], each a number";
  EXPECT_EQ(errorOf("{uniform: 3}"), "found uniform: 3; " + should);
  EXPECT_EQ(errorOf("{uniform: [1, 2, 3]}"), "found uniform: [1, 2, 3]; " + should);
  EXPECT_EQ(errorOf("{log_uniform: [1, x]}"), "found log_uniform: [1, x]; " + should);
  EXPECT_EQ(errorOf("{uniform: [3, 1]}"),
            "found uniform: [3, 1]; it should be [low, high], low not above high");
  EXPECT_EQ(errorOf("{uniform: [[0, 3, 0], 1]}", kPosition),
            "found uniform: [[0, 3, 0], 1]; it should be [low, high], low not above high");
}

TEST(MaybeDistribution, RefusesALogarithmOfZero) {
  EXPECT_EQ(errorOf("{log_uniform: [0, 1]}"),
            "found log_uniform: [0, 1]; it should be [low, high], both above 0");
  EXPECT_EQ(errorOf("{log_uniform: [[1, -1, 1], 2]}", kPosition),
            "found log_uniform: [[1, -1, 1], 2]; it should be [low, high], both above 0");
}

TEST(MaybeDistribution, RefusesNormalOnesThatAreNone) {
  EXPECT_EQ(errorOf("{normal: 3}"), "found normal: 3; it should be [mean, stddev], each a number");
  EXPECT_EQ(errorOf("{normal: [1, -2]}"),
            "found normal: [1, -2]; it should be [mean, stddev], stddev not below 0");
  EXPECT_EQ(errorOf("{normal: [1, 2], max: much}"), "found max: much; it should be a number");
  EXPECT_EQ(errorOf("{normal: [1, 2], min: 3, max: 0}"),
            "found normal: [1, 2], min: 3, max: 0; it should be [mean, stddev], mean not below min "
            "and not above max");
  EXPECT_EQ(errorOf("{normal: [1, 2], max: 0.5}"),
            "found normal: [1, 2], max: 0.5; it should be [mean, stddev], mean not below min and "
            "not above max");
  EXPECT_EQ(errorOf("{normal: [1, 2], min: 1.5}"),
            "found normal: [1, 2], min: 1.5; it should be [mean, stddev], mean not below min and "
            "not above max");
}

TEST(MaybeDistribution, TakesSpreadsOfMoreThanHalfATurnForDegrees) {
  EXPECT_EQ(
      errorOf("{normal: [0, 5]}", kTurnRange),
      "found normal: [0, 5]; it should be [mean, stddev], stddev at most half a turn of 3.142 "
      "rad (degrees are written deg(20))");
  EXPECT_EQ(errorOf("{uniform: [-90, 90]}", kTurnRange),
            "found uniform: [-90, 90]; it should be -6.283185307179586 to 6.283185307179586 rad "
            "(degrees are written deg(20))");
}

TEST(MaybeDistribution, RefusesChoicesThatAreNone) {
  EXPECT_EQ(errorOf("{choice: []}"), "found choice: []; it should be a list, each entry a number");
  EXPECT_EQ(errorOf("{choice: 3}"), "found choice: 3; it should be a list, each entry a number");
  EXPECT_EQ(errorOf("{choice: [3, red]}"), "found red in choice; it should be a number");
}

TEST(MaybeDistribution, RefusesWrongWeights) {
  EXPECT_EQ(errorOf("{choice: [1, 2], weights: [1, 2, 3]}"),
            "found weights: [1, 2, 3]; it should be a list of 2 numbers, one for each choice");
  EXPECT_EQ(errorOf("{choice: [1], weights: much}"),
            "found weights: much; it should be a list of 1 number, one for each choice");
  EXPECT_EQ(errorOf("{choice: [1, 2], weights: [1, -1]}"),
            "found weights: [1, -1]; it should be numbers not below 0");
  EXPECT_EQ(errorOf("{choice: [1, 2], weights: [0, 0]}"),
            "found weights: [0, 0]; it should be numbers, at least one above 0");
}

TEST(MaybeDistribution, RefusesWhatIsOutOfRange) {
  EXPECT_EQ(errorOf("2", kShare), "found 2; it should be 0.0 to 1.0");
  EXPECT_EQ(errorOf("[0, 0, -1]", kColour), "found [0, 0, -1]; it should be 0.0 to 1.0");
  EXPECT_EQ(errorOf("{uniform: [0, 2]}", kShare), "found uniform: [0, 2]; it should be 0.0 to 1.0");
  EXPECT_EQ(errorOf("{uniform: [-1, 1]}", kShare),
            "found uniform: [-1, 1]; it should be 0.0 to 1.0");
  EXPECT_EQ(errorOf("{normal: [2, 1]}", kShare), "found normal: [2, 1]; it should be 0.0 to 1.0");
  EXPECT_EQ(errorOf("{normal: [1, 1], max: 3}", kShare), "found max: 3; it should be 0.0 to 1.0");
  EXPECT_EQ(errorOf("{choice: [0, 3], weights: [1, 0]}", kShare),
            "found 3 in choice; it should be 0.0 to 1.0");
}

TEST(MaybeDistribution, NamesAnOpenRange) {
  EXPECT_EQ(errorOf("-1", {1, 0.0, kInfinity}), "found -1; it should be 0.0 or more");
  EXPECT_EQ(errorOf("1", {1, -kInfinity, 0.5}), "found 1; it should be 0.5 or less");
}

TEST(MaybeDistribution, CutsLongListsShort) {
  std::string many = "0";
  for (int i = 0; i < 100; ++i) many += ", 0";
  const std::string error = errorOf("{uniform: [" + many + "]}");
  EXPECT_LT(error.size(), 160U);
  EXPECT_THAT(error, ::testing::HasSubstr("...; it should be [low, high]"));
}

TEST(MaybeChoice, ReadsOneTextOrSeveral) {
  Parameters root = Parameters(base::parseYaml(
      "sun: {a: oak, b: {choice: [oak, pine]}, c: {choice: [oak, pine], weights: [1, 0]}}", "t"));
  Parameters group = root.group("sun");
  EXPECT_FALSE(maybeChoice(group, "nothing"));
  EXPECT_THAT(maybeChoice(group, "a")->texts, ElementsAre("oak"));
  EXPECT_THAT(maybeChoice(group, "b")->texts, ElementsAre("oak", "pine"));
  EXPECT_THAT(maybeChoice(group, "b")->weights, IsEmpty());
  EXPECT_THAT(maybeChoice(group, "c")->weights, ElementsAre(1.0, 0.0));
  EXPECT_THAT(root.errors(), IsEmpty());
  EXPECT_THAT(root.unknownNames(), IsEmpty());
}

TEST(MaybeChoice, RefusesWhatIsNone) {
  EXPECT_EQ(choiceErrorOf("3"),
            "found 3 (a whole number); it should be a text, or a group with "
            "choice");
  EXPECT_EQ(choiceErrorOf("{}"), "found an empty group; it should be a group with choice");
  EXPECT_EQ(choiceErrorOf("{chioce: [a]}"),
            "found 'chioce'; it should be a group with choice; did you mean 'choice'?");
  EXPECT_EQ(choiceErrorOf("{choice: [a], min: 1}"),
            "found 'min' beside choice; it should be choice with weights at most");
  EXPECT_EQ(choiceErrorOf("{choice: a}"), "found choice: a; it should be a list of texts");
  EXPECT_EQ(choiceErrorOf("{choice: []}"), "found choice: []; it should be a list of texts");
  EXPECT_EQ(choiceErrorOf("{choice: [a, 1]}"),
            "found choice: [a, 1]; it should be a list of texts");
  EXPECT_EQ(choiceErrorOf("{choice: [a, b], weights: [1]}"),
            "found weights: [1]; it should be a list of 2 numbers, one for each choice");
}

}  // namespace distribution_config_test
}  // namespace synthetic_dataset::config

#include "randomize/appearance/pattern.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

namespace synthetic_dataset::randomize {
namespace pattern_test {

constexpr std::uint64_t kPatterns = 100;

struct Pattern {
  std::string kind;
  cv::Mat pixels;
};

Pattern patternOf(std::uint64_t seed) {
  base::RandomSource random(seed);
  const auto [kind, texture] = drawPattern(random);
  return {kind, texture->pixels};
}

bool isSmooth(const std::string& kind) { return kind == "gradient" || kind == "clouds"; }

/// The greatest difference of one channel of two columns.
double stepBetween(const cv::Mat& picture, int left, int right) {
  return cv::norm(picture.col(left), picture.col(right), cv::NORM_INF);
}

double greatestStepInside(const cv::Mat& picture) {
  double greatest = 0.0;
  for (int column = 1; column < picture.cols; ++column) {
    greatest = std::max(greatest, stepBetween(picture, column - 1, column));
  }
  return greatest;
}

/// How far a pixel is from the segment between two colours.
double distanceToMixture(const cv::Vec4d& pixel, const cv::Vec4d& first, const cv::Vec4d& second) {
  const cv::Vec4d way = second - first;
  const double length = way.dot(way);
  const double share = length > 0.0 ? std::clamp((pixel - first).dot(way) / length, 0.0, 1.0) : 0.0;
  return cv::norm(pixel - (first + share * way));
}

/// Two pixels that are far from one another, found without comparing all pairs.
std::array<cv::Vec4d, 2> extremesOf(const cv::Mat& picture) {
  const auto farthestFrom = [&](const cv::Vec4d& from) {
    cv::Vec4d farthest = from;
    for (int row = 0; row < picture.rows; ++row) {
      for (int column = 0; column < picture.cols; ++column) {
        const cv::Vec4d pixel = picture.at<cv::Vec4b>(row, column);
        if (cv::norm(pixel - from) > cv::norm(farthest - from)) farthest = pixel;
      }
    }
    return farthest;
  };
  const cv::Vec4d first = farthestFrom(cv::Vec4d(picture.at<cv::Vec4b>(0, 0)));
  return {first, farthestFrom(first)};
}

TEST(Pattern, HasFiveKindsThatAllCome) {
  std::map<std::string, int> counts;
  for (std::uint64_t seed = 0; seed < kPatterns; ++seed) ++counts[patternOf(seed).kind];
  EXPECT_THAT(counts, testing::UnorderedElementsAre(testing::Pair("checkers", testing::Gt(5)),
                                                    testing::Pair("stripes", testing::Gt(5)),
                                                    testing::Pair("dots", testing::Gt(5)),
                                                    testing::Pair("gradient", testing::Gt(5)),
                                                    testing::Pair("clouds", testing::Gt(5))));
}

TEST(Pattern, IsAnOpaquePicture) {
  for (std::uint64_t seed = 0; seed < kPatterns; ++seed) {
    const cv::Mat picture = patternOf(seed).pixels;
    ASSERT_EQ(picture.type(), CV_8UC4);
    ASSERT_GT(picture.total(), 1000U);
    cv::Mat alpha;
    cv::extractChannel(picture, alpha, 3);
    EXPECT_EQ(cv::countNonZero(alpha != 255), 0) << seed;
  }
}

TEST(Pattern, IsOfTwoColoursAndWhatLiesBetween) {
  for (std::uint64_t seed = 0; seed < kPatterns; ++seed) {
    const Pattern pattern = patternOf(seed);
    const auto [first, second] = extremesOf(pattern.pixels);
    EXPECT_GT(cv::norm(first - second), 5.0) << seed << ": something is seen of " << pattern.kind;
    double worst = 0.0;
    for (int row = 0; row < pattern.pixels.rows; ++row) {
      for (int column = 0; column < pattern.pixels.cols; ++column) {
        const cv::Vec4d pixel = pattern.pixels.at<cv::Vec4b>(row, column);
        worst = std::max(worst, distanceToMixture(pixel, first, second));
      }
    }
    EXPECT_LT(worst, 2.0) << pattern.kind << ", " << seed;
  }
}

TEST(Pattern, ContinuesAcrossItsEdgesWhereItIsSmooth) {
  int smooth = 0;
  for (std::uint64_t seed = 0; seed < kPatterns; ++seed) {
    const Pattern pattern = patternOf(seed);
    if (!isSmooth(pattern.kind)) continue;
    ++smooth;
    for (const cv::Mat& picture : {pattern.pixels, cv::Mat(pattern.pixels.t())}) {
      EXPECT_LE(stepBetween(picture, picture.cols - 1, 0), greatestStepInside(picture) + 1.0)
          << pattern.kind << ", " << seed;
    }
  }
  EXPECT_GT(smooth, 20);
}

/// Two copies of a pattern side by side have no edges that a single one does not have.
TEST(Pattern, RepeatsWholeCheckersStripesAndDots) {
  for (std::uint64_t seed = 0; seed < kPatterns; ++seed) {
    const Pattern pattern = patternOf(seed);
    if (isSmooth(pattern.kind)) continue;
    const cv::Mat& picture = pattern.pixels;
    const auto changes = [&](int left, int right) {
      int count = 0;
      for (int row = 0; row < picture.rows; ++row) {
        const cv::Vec4b& pixel = picture.at<cv::Vec4b>(row, left);
        if (cv::norm(cv::Vec4d(pixel) - cv::Vec4d(picture.at<cv::Vec4b>(row, right))) > 2.0) {
          ++count;
        }
      }
      return count;
    };
    int most = 0;
    for (int column = 1; column < picture.cols; ++column) {
      most = std::max(most, changes(column - 1, column));
    }
    EXPECT_LE(changes(picture.cols - 1, 0), most) << pattern.kind << ", " << seed;
  }
}

/// The lengths of runs of one colour in the first row of a picture that repeats.
std::vector<int> runsIn(const cv::Mat& picture) {
  std::vector<int> changes;
  for (int column = 0; column < picture.cols; ++column) {
    const int before = (column + picture.cols - 1) % picture.cols;
    if (stepBetween(picture.row(0), before, column) > 0.0) changes.push_back(column);
  }
  std::vector<int> runs;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const bool is_last = i + 1 == changes.size();
    runs.push_back((is_last ? changes.front() + picture.cols : changes[i + 1]) - changes[i]);
  }
  return runs;
}

TEST(Pattern, HasCheckersOfOneSizeAcrossItsEdgesToo) {
  int checkers = 0;
  for (std::uint64_t seed = 0; seed < kPatterns; ++seed) {
    const Pattern pattern = patternOf(seed);
    if (pattern.kind != "checkers") continue;
    ++checkers;
    for (const cv::Mat& picture : {pattern.pixels, cv::Mat(pattern.pixels.t())}) {
      const std::vector<int> runs = runsIn(picture);
      ASSERT_GE(runs.size(), 2U);
      const auto [shortest, longest] = std::minmax_element(runs.begin(), runs.end());
      EXPECT_LE(*longest - *shortest, 1) << seed;
    }
  }
  EXPECT_GT(checkers, 5);
}

TEST(Pattern, IsTheSameOfTheSameNumbersAndAnotherOfOthers) {
  int alike = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Pattern pattern = patternOf(seed);
    const Pattern again = patternOf(seed);
    EXPECT_EQ(pattern.kind, again.kind);
    EXPECT_EQ(cv::norm(pattern.pixels, again.pixels, cv::NORM_INF), 0.0);
    const Pattern other = patternOf(seed + 1);
    alike += cv::norm(pattern.pixels, other.pixels, cv::NORM_INF) == 0.0 ? 1 : 0;
  }
  EXPECT_EQ(alike, 0);
}

}  // namespace pattern_test
}  // namespace synthetic_dataset::randomize

#include "randomize/appearance/natural_pool.h"

#include <set>
#include <string>

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

namespace synthetic_dataset::randomize {
namespace natural_pool_test {

TEST(NaturalPool, NamesAPictureByWhatItIsAndItsNumber) {
  NaturalPool textures(NaturalUse::kTexture);
  NaturalPool backgrounds(NaturalUse::kBackground);
  for (std::size_t i = 0; i < 8; ++i) {
    const std::string number = "/" + std::to_string(i);
    EXPECT_THAT(textures.read(i)->file, testing::MatchesRegex("natural/[a-z]+" + number));
    EXPECT_THAT(backgrounds.read(i)->file, testing::MatchesRegex("natural/[a-z]+" + number));
  }
}

/// A picture does not depend on which others the run has drawn before.
TEST(NaturalPool, HasTheSamePicturesInEachRun) {
  for (const NaturalUse use : {NaturalUse::kTexture, NaturalUse::kBackground}) {
    NaturalPool pool(use);
    NaturalPool other(use);
    (void)other.read(3);
    for (const std::size_t i : {7, 0, 255}) {
      const auto picture = pool.read(i);
      const auto same = other.read(i);
      EXPECT_NE(picture, same);
      EXPECT_EQ(picture->file, same->file);
      ASSERT_EQ(picture->pixels.size(), same->pixels.size());
      EXPECT_EQ(cv::norm(picture->pixels, same->pixels, cv::NORM_INF), 0.0);
    }
  }
}

TEST(NaturalPool, KeepsWhatItHasMadeLast) {
  NaturalPool pool(NaturalUse::kTexture);
  const auto first = pool.read(5);
  EXPECT_EQ(pool.read(5), first);
  for (std::size_t i = 10; i < 42; ++i) (void)pool.read(i);
  EXPECT_NE(pool.read(5), first) << "not all are kept";
}

TEST(NaturalPool, HasTexturesOfTwoSizesAndBackgroundsOfMore) {
  NaturalPool textures(NaturalUse::kTexture);
  NaturalPool backgrounds(NaturalUse::kBackground);
  std::set<int> sides;
  std::set<std::pair<int, int>> sizes;
  for (std::size_t i = 0; i < 24; ++i) {
    const cv::Mat texture = textures.read(i)->pixels;
    EXPECT_EQ(texture.cols, texture.rows);
    sides.insert(texture.cols);
    const cv::Mat background = backgrounds.read(i)->pixels;
    EXPECT_EQ(background.cols * 3, background.rows * 4);
    sizes.insert({background.cols, background.rows});
  }
  EXPECT_THAT(sides, testing::ElementsAre(256, 512));
  EXPECT_EQ(sizes.size(), 4U);
}

}  // namespace natural_pool_test
}  // namespace synthetic_dataset::randomize

#include "motion/frame_names.h"

#include <gtest/gtest.h>

namespace synthetic_dataset::motion {
namespace frame_names_test {

const std::vector<std::string> kFrames = {"map", "alpha/odom", "alpha/base_link",
                                          "bravo/base_link"};

TEST(WithoutLeadingSlashes, LeavesTheRestOfTheName) {
  EXPECT_EQ(withoutLeadingSlashes("/map"), "map");
  EXPECT_EQ(withoutLeadingSlashes("//alpha/base_link"), "alpha/base_link");
  EXPECT_EQ(withoutLeadingSlashes("alpha/"), "alpha/");
}

TEST(WithoutLeadingSlashes, CanLeaveNothing) {
  EXPECT_EQ(withoutLeadingSlashes("/"), "");
  EXPECT_EQ(withoutLeadingSlashes(""), "");
}

TEST(DidYouMeanFrame, FindsATypingMistake) {
  EXPECT_EQ(didYouMeanFrame("alpha/base_lnk", kFrames), "; did you mean 'alpha/base_link'?");
}

TEST(DidYouMeanFrame, FindsAMissingPrefix) {
  EXPECT_EQ(didYouMeanFrame("base_link", kFrames),
            "; did you mean 'alpha/base_link' or 'bravo/base_link'?");
}

TEST(DidYouMeanFrame, FindsAPrefixTooMany) {
  EXPECT_EQ(didYouMeanFrame("robots/alpha/odom", kFrames), "; did you mean 'alpha/odom'?");
}

TEST(DidYouMeanFrame, FindsOtherSeparatorsAndCapitals) {
  EXPECT_EQ(didYouMeanFrame("alpha_base_link", kFrames), "; did you mean 'alpha/base_link'?");
  EXPECT_EQ(didYouMeanFrame("Map", kFrames), "; did you mean 'map'?");
}

TEST(DidYouMeanFrame, SaysNothingWhenNothingIsAlike) {
  EXPECT_EQ(didYouMeanFrame("camera_mount", kFrames), "");
  EXPECT_EQ(didYouMeanFrame("", kFrames), "");
}

}  // namespace frame_names_test
}  // namespace synthetic_dataset::motion

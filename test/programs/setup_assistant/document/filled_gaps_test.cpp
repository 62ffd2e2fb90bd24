#include "programs/setup_assistant/document/filled_gaps.h"

#include <gtest/gtest.h>

namespace synthetic_dataset::programs {
namespace {

TEST(FilledGaps, RemoveTheRemarkBehindASettingThatWasSet) {
  EXPECT_EQ(
      "global_frame: map  # as in the bag\nrobot_list: [\"husky\"]\n",
      withoutGap("global_frame: map  # as in the bag\nrobot_list: [\"husky\"]  # TODO: which?\n",
                 "file", {"robot_list"}));
}

TEST(FilledGaps, RemoveTheRemarkBehindAGroupInOneLine) {
  EXPECT_EQ(
      "camera:\n  pose: {position: [1, 0, 2], look_at: [0, 0, 0]}\n",
      withoutGap("camera:\n  pose: {position: [1, 0, 2], look_at: [0, 0, 0]}  # TODO: where?\n",
                 "file", {"camera", "pose", "position"}));
}

TEST(FilledGaps, RemoveTheSettingInACommentOfItsGroup) {
  const std::string other = "b:\n  class: b\n  # model: /path/to/b.urdf  # TODO: a box\n";
  EXPECT_EQ("a:\n  class: a\n  model: \"a.urdf\"\n" + other,
            withoutGap("a:\n  class: a\n  model: \"a.urdf\"\n"
                       "  # model: /path/to/a.urdf  # TODO: a box\n" +
                           other,
                       "file", {"a", "model"}));
}

TEST(FilledGaps, LeaveTheRemarksOfOtherSettings) {
  const std::string text = "global_frame: map  # TODO: which?\nseed: 1\n";
  EXPECT_EQ(text, withoutGap(text, "file", {"seed"}));
}

TEST(FilledGaps, LeaveTextsThatLookLikeRemarks) {
  const std::string text = "note: {a: \"b\", c: \"d # TODO: e\"}\n";
  EXPECT_EQ(text, withoutGap(text, "file", {"note", "a"}));
}

}  // namespace
}  // namespace synthetic_dataset::programs

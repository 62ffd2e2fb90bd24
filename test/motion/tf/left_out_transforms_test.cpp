#include "motion/tf/left_out_transforms.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace synthetic_dataset::motion {
namespace left_out_transforms_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

geometry_msgs::TransformStamped goodTransform() {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "map";
  transform.header.stamp = ros::Time(12.5);
  transform.child_frame_id = "alpha";
  transform.transform.rotation.w = 1.0;
  return transform;
}

std::string reasonFor(const geometry_msgs::TransformStamped& transform) {
  return reasonToLeaveOut(transform, TransformKind::kMoving).value_or("none");
}

TEST(ReasonToLeaveOut, IsNoneForAGoodTransform) { EXPECT_EQ(reasonFor(goodTransform()), "none"); }

TEST(ReasonToLeaveOut, NamesNumbersThatAreNone) {
  auto transform = goodTransform();
  transform.transform.translation.y = std::nan("");
  EXPECT_EQ(reasonFor(transform), "NaN in the translation");
  transform.transform.translation.y = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(reasonFor(transform), "infinity in the translation");
  transform = goodTransform();
  transform.transform.rotation.x = std::nan("");
  EXPECT_EQ(reasonFor(transform), "NaN in the rotation");
  transform.transform.rotation.x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(reasonFor(transform), "infinity in the rotation");
}

TEST(ReasonToLeaveOut, AllowsTf2sToleranceOfAQuaternionsLength) {
  auto transform = goodTransform();
  transform.transform.rotation.w = 1.0049;  // squared 1.00982
  EXPECT_EQ(reasonFor(transform), "none");
  transform.transform.rotation.w = 1.0051;  // squared 1.01023
  EXPECT_THAT(reasonFor(transform), HasSubstr("not a quaternion of unit length"));
  transform.transform.rotation.w = 0.0;
  EXPECT_THAT(reasonFor(transform), HasSubstr("not a quaternion of unit length"));
}

TEST(ReasonToLeaveOut, NamesFramesThatAreNone) {
  auto transform = goodTransform();
  transform.child_frame_id = "map";
  EXPECT_EQ(reasonFor(transform), "the frame is its own parent");
  transform.child_frame_id = "";
  EXPECT_EQ(reasonFor(transform), "the child frame has no name");
  transform = goodTransform();
  transform.header.frame_id = "";
  EXPECT_EQ(reasonFor(transform), "the parent frame has no name");
}

TEST(ReasonToLeaveOut, AllowsStampsOfZeroInStaticTransformsOnly) {
  auto transform = goodTransform();
  transform.header.stamp = ros::Time();
  EXPECT_EQ(reasonFor(transform), "the time stamp is zero or out of range");
  EXPECT_EQ(reasonToLeaveOut(transform, TransformKind::kStatic), std::nullopt);
}

TEST(LeftOutTransforms, CountsByBagFramesAndReason) {
  LeftOutTransforms left_out;
  left_out.add("a.bag", "map", "alpha", "NaN in the rotation", Stamp(12300000000));
  left_out.add("a.bag", "map", "alpha", "NaN in the rotation", Stamp(12400000000));
  left_out.add("b.bag", "map", "alpha", "NaN in the rotation", Stamp(12500000000));
  left_out.add("", "map", "bravo", "a reason", Stamp(12600000000));
  EXPECT_THAT(
      left_out.notes(),
      ElementsAre("bag a.bag: 2 transforms of map -> alpha were left out: NaN in the rotation "
                  "(first at 12.300000000 s)",
                  "bag b.bag: 1 transform of map -> alpha was left out: NaN in the rotation "
                  "(first at 12.500000000 s)",
                  "1 transform of map -> bravo was left out: a reason (first at 12.600000000 s)"));
}

}  // namespace left_out_transforms_test
}  // namespace synthetic_dataset::motion

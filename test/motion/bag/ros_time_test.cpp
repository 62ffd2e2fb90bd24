#include <gtest/gtest.h>

#include "motion/bag/ros_time.h"

namespace synthetic_dataset::motion {
namespace time_text_test {

TEST(SecondsText, KeepsEveryNanosecondOfUnixTimes) {
  EXPECT_EQ(secondsText(Stamp(1650000002623456789)), "1650000002.623456789 s");
}

TEST(SecondsText, FillsDecimalsWithZeros) {
  EXPECT_EQ(secondsText(Stamp(12300000000)), "12.300000000 s");
  EXPECT_EQ(secondsText(Stamp(7)), "0.000000007 s");
}

TEST(SecondsText, KeepsTheSignOfTimesShorterThanASecond) {
  EXPECT_EQ(secondsText(Duration(-1500000000)), "-1.500000000 s");
  EXPECT_EQ(secondsText(Duration(-500000000)), "-0.500000000 s");
}

}  // namespace time_text_test
}  // namespace synthetic_dataset::motion

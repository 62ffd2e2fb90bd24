#include "base/angle_expression.h"

#include <string>

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace angle_expression_test {

using ::testing::HasSubstr;

constexpr double kPi = 3.141592653589793;

TEST(Radians, ComputesAsPythonDoes) {
  EXPECT_EQ(radians("pi"), kPi);
  EXPECT_EQ(radians("pi/2"), kPi / 2.0);
  EXPECT_EQ(radians(" - 2 * pi "), -2.0 * kPi);
  EXPECT_EQ(radians("1 - 2 - 3"), -4.0);
  EXPECT_EQ(radians("8/4/2"), 1.0);
  EXPECT_EQ(radians("2*(3+4)"), 14.0);
  EXPECT_EQ(radians("-2**2"), -4.0);
  EXPECT_EQ(radians("2**-1"), 0.5);
  EXPECT_EQ(radians("2**3**2"), 512.0);
  EXPECT_EQ(radians("1.5e+1 + .5"), 15.5);
}

TEST(Radians, RefusesWhatIsNoArithmetic) {
  for (const std::string text : {"", "pi pi", "2pi", "1/0", "(1", "1)", "sqrt(2)", "1 +", "1..2",
                                 "10**400", "(0-1)**0.5", "0x10"}) {
    EXPECT_THAT(test::messagesOf([&] { return radians(text); }),
                testing::ElementsAre(HasSubstr("found the angle '" + text + "'")))
        << text;
  }
}

TEST(Radians, RefusesWhatNestsWithoutBound) {
  EXPECT_THROW((void)radians(std::string(100000, '(')), Error);
  EXPECT_THROW((void)radians(std::string(100000, '-')), Error);
}

TEST(Degrees, AreTurnedIntoRadians) {
  EXPECT_EQ(degrees("180"), kPi);
  EXPECT_EQ(degrees(" -90.0 "), -kPi / 2.0);
}

TEST(Degrees, AreOneNumber) {
  EXPECT_THROW((void)degrees("90+90"), Error);
  EXPECT_THROW((void)degrees("pi"), Error);
  EXPECT_THROW((void)degrees(" "), Error);
}

}  // namespace angle_expression_test
}  // namespace synthetic_dataset::base

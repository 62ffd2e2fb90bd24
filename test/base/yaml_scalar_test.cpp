#include "base/yaml_scalar.h"

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace synthetic_dataset::base {
namespace yaml_scalar_test {

// Expected values: what yaml.safe_load of PyYAML 6.0 returns for each text.

TEST(PlainScalar, ReadsWholeNumbersOfAllBases) {
  EXPECT_EQ(plainScalar("0"), Value(0));
  EXPECT_EQ(plainScalar("-12"), Value(-12));
  EXPECT_EQ(plainScalar("+1_000"), Value(1000));
  EXPECT_EQ(plainScalar("010"), Value(8));
  EXPECT_EQ(plainScalar("-0x1F"), Value(-31));
  EXPECT_EQ(plainScalar("0b101"), Value(5));
  EXPECT_EQ(plainScalar("9223372036854775807"), Value(std::numeric_limits<std::int64_t>::max()));
}

TEST(PlainScalar, ReadsBase60) {
  EXPECT_EQ(plainScalar("1:30"), Value(90));
  EXPECT_EQ(plainScalar("-1:00:01"), Value(-3601));
  EXPECT_EQ(plainScalar("1:30.5"), Value(90.5));
  EXPECT_EQ(plainScalar("1:60"), Value("1:60"));
  EXPECT_EQ(plainScalar("0:30"), Value("0:30"));
}

TEST(PlainScalar, TakesForAFloatOnlyWhatHasAPoint) {
  EXPECT_EQ(plainScalar("2.50"), Value(2.5));
  EXPECT_EQ(plainScalar("1."), Value(1.0));
  EXPECT_EQ(plainScalar(".5"), Value(0.5));
  EXPECT_EQ(plainScalar("1.0e+5"), Value(1e5));
  EXPECT_EQ(plainScalar("1.0e+400"), Value(std::numeric_limits<double>::infinity()));
  EXPECT_EQ(plainScalar("-.inf"), Value(-std::numeric_limits<double>::infinity()));
  EXPECT_TRUE(std::isnan(*plainScalar(".nan").as<double>()));
  EXPECT_EQ(plainScalar("1e5"), Value("1e5"));
  EXPECT_EQ(plainScalar("1.0e5"), Value("1.0e5"));
  EXPECT_EQ(plainScalar("-.5"), Value("-.5"));
}

TEST(PlainScalar, LeavesAllElseATextWhateverItsLength) {
  EXPECT_EQ(plainScalar("08"), Value("08"));
  EXPECT_EQ(plainScalar("0b_"), Value("0b_"));
  EXPECT_EQ(plainScalar("y"), Value("y"));
  EXPECT_EQ(plainScalar("yEs"), Value("yEs"));
  EXPECT_EQ(plainScalar("9223372036854775808"), Value("9223372036854775808"));
  const std::string long_text(1000000, '1');
  EXPECT_EQ(plainScalar(long_text), Value(long_text));
}

TEST(IsTimestamp, KnowsDatesAndTimes) {
  EXPECT_TRUE(isTimestamp("2001-12-14"));
  EXPECT_TRUE(isTimestamp("2001-12-14t21:59:43.10-05:00"));
  EXPECT_TRUE(isTimestamp("2001-1-4 1:59:43 Z"));
  EXPECT_FALSE(isTimestamp("2001-1-4"));
  EXPECT_FALSE(isTimestamp("2001-12-14 21:59"));
}

TEST(DecimalNumber, IsNothingElse) {
  EXPECT_EQ(decimalNumber("1e5"), 1e5);
  EXPECT_EQ(decimalNumber("-.5"), -0.5);
  EXPECT_EQ(decimalNumber(""), std::nullopt);
  EXPECT_EQ(decimalNumber("0x10"), std::nullopt);
  EXPECT_EQ(decimalNumber("1 2"), std::nullopt);
}

}  // namespace yaml_scalar_test
}  // namespace synthetic_dataset::base

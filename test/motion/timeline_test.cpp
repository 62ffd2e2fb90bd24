#include "motion/timeline.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/recorded.h"

namespace synthetic_dataset::motion {
namespace timeline_test {

using ::testing::HasSubstr;

TEST(PeriodOf, IsCutToWholeNanoseconds) {
  EXPECT_EQ(periodOf(30.0), Duration(33333333));
  EXPECT_EQ(periodOf(3.0), Duration(333333333));
  EXPECT_EQ(periodOf(60.0), Duration(16666666));
  EXPECT_EQ(periodOf(29.97), Duration(33366700));
}

TEST(PeriodOf, IsExactWhereTheRateDividesASecond) {
  EXPECT_EQ(periodOf(4.0), Duration(250000000));
  EXPECT_EQ(periodOf(10.0), Duration(100000000));
  EXPECT_EQ(periodOf(1000.0), Duration(1000000));
}

TEST(PeriodOf, IsLongForRatesBelowOne) {
  EXPECT_EQ(periodOf(0.5), Duration(2000000000));
  EXPECT_EQ(periodOf(0.1), Duration(10000000000));
  EXPECT_EQ(periodOf(1.0 / 3.0), Duration(3000000000));
  EXPECT_EQ(periodOf(1e-6), Duration(1000000000000000));
}

TEST(PeriodOf, EqualsIntegerDivisionForWholeRates) {
  for (std::int64_t rate = 1; rate <= 20000; ++rate) {
    ASSERT_EQ(periodOf(static_cast<double>(rate)).count(), 1000000000 / rate) << rate << " Hz";
  }
}

TEST(PeriodOf, EqualsIntegerDivisionForRatesInTenths) {
  for (std::int64_t tenths = 1; tenths <= 20000; ++tenths) {
    const double rate = static_cast<double>(tenths) / 10.0;
    ASSERT_EQ(periodOf(rate).count(), 10000000000 / tenths) << rate << " Hz";
  }
}

TEST(PeriodOf, GivesBackThePeriodThatARateWasMadeFrom) {
  for (std::int64_t milliseconds = 1; milliseconds <= 20000; ++milliseconds) {
    const double rate = 1.0 / (static_cast<double>(milliseconds) / 1000.0);
    ASSERT_EQ(periodOf(rate).count(), milliseconds * 1000000) << rate << " Hz";
  }
}

TEST(PeriodOf, RefusesRatesThatHaveNoPeriod) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double rate : {0.0, -30.0, 2e9, 1e-12, kInfinity, std::nan("")}) {
    EXPECT_THAT(messageOf([rate] { static_cast<void>(periodOf(rate)); }),
                HasSubstr("it has to be above 0"))
        << rate;
  }
}

TEST(Timeline, KnowsHowOftenTimesUsuallyCome) {
  using std::chrono::milliseconds;
  EXPECT_EQ(usualRate({milliseconds(0), milliseconds(100), milliseconds(200), milliseconds(900)}),
            10.0);
  EXPECT_FALSE(usualRate({milliseconds(7)}));
}

}  // namespace timeline_test
}  // namespace synthetic_dataset::motion

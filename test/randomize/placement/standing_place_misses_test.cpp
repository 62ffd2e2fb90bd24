#include <gtest/gtest.h>

#include "randomize/placement/standing_place.h"

namespace synthetic_dataset::randomize {
namespace miss_reasons_test {

TEST(ReasonsText, NamesTheMostFrequentFirst) {
  EXPECT_EQ(reasonsText({{"were too near 'alpha'", 3}, {"were inside 'shelf'", 612}}),
            "612 were inside 'shelf', 3 were too near 'alpha'");
}

TEST(ReasonsText, LeavesOutTheRarest) {
  EXPECT_EQ(reasonsText({{"a", 1}, {"b", 5}, {"c", 4}, {"d", 3}, {"e", 2}}), "5 b, 4 c, 3 d, 2 e");
}

TEST(ReasonsText, IsEmptyWithoutMisses) { EXPECT_EQ(reasonsText({}), ""); }

}  // namespace miss_reasons_test
}  // namespace synthetic_dataset::randomize

#include "base/name_pattern.h"

#include <gtest/gtest.h>

namespace synthetic_dataset::base {
namespace name_pattern_test {

TEST(NamePattern, IsTheNameWhereItHasNoStar) {
  EXPECT_TRUE(matchesPattern("wall", "wall"));
  EXPECT_FALSE(matchesPattern("wall", "wal"));
  EXPECT_FALSE(matchesPattern("wal", "wall"));
  EXPECT_FALSE(matchesPattern("wall_[1]", "wall_[12]"));  // brackets are ordinary characters
}

TEST(NamePattern, StandsForAnyTextAtAStar) {
  EXPECT_TRUE(matchesPattern("wall_12", "wall_*"));
  EXPECT_TRUE(matchesPattern("wall_", "wall_*"));
  EXPECT_FALSE(matchesPattern("my_wall", "wall*"));
  EXPECT_TRUE(matchesPattern("house::roof::left", "*::roof::*"));
  EXPECT_TRUE(matchesPattern("abcabd", "*abd"));  // the first `ab` leads nowhere
  EXPECT_TRUE(matchesPattern("", "*"));
  EXPECT_FALSE(matchesPattern("", "?"));
}

TEST(NamePattern, StandsForOneCharacterAtAQuestionMark) {
  EXPECT_TRUE(matchesPattern("leg_3", "leg_?"));
  EXPECT_FALSE(matchesPattern("leg_13", "leg_?"));
}

}  // namespace name_pattern_test
}  // namespace synthetic_dataset::base

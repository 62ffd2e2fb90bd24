#include "base/name_list.h"

#include <gtest/gtest.h>

namespace synthetic_dataset::base {
namespace name_list_test {

TEST(NameList, HasCommasBetween) {
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(listed({"odom"}), "odom");
  EXPECT_EQ(listed({"odom", "base_link"}), "odom, base_link");
}

TEST(NameList, CountsWhatItDoesNotName) {
  EXPECT_EQ(listed({"a", "b", "c"}, 3), "a, b, c");
  EXPECT_EQ(listed({"a", "b", "c", "d", "e"}, 3), "a, b, c and 2 more");
}

}  // namespace name_list_test
}  // namespace synthetic_dataset::base

#include "output/files/file_name_rules.h"

#include <gmock/gmock.h>

namespace synthetic_dataset::output {
namespace file_name_rules_test {

TEST(LiesWithin, ComparesWholeParts) {
  EXPECT_TRUE(liesWithin("/a/b", "/a/b"));
  EXPECT_TRUE(liesWithin("/a/b/c", "/a/b/"));
  EXPECT_FALSE(liesWithin("/a/bc", "/a/b"));
  EXPECT_FALSE(liesWithin("/a", "/a/b"));
}

}  // namespace file_name_rules_test
}  // namespace synthetic_dataset::output

#include "run/check/finding.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace synthetic_dataset::run {
namespace finding_test {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::vector<std::string> messagesOf(const std::vector<Finding>& findings) {
  std::vector<std::string> messages;
  for (const Finding& each : joinAlike(findings)) messages.push_back(each.message());
  return messages;
}

TEST(JoinAlike, LeavesAFewAsTheyAre) {
  const std::vector<Finding> few(4, {"size", "rover", "its model is 390 m long", "scale it"});
  EXPECT_EQ(messagesOf(few).size(), 4u);
}

TEST(JoinAlike, LetsTheFirstOfManySpeakForThem) {
  std::vector<Finding> many = {{"dark", "pictures", "are dark", ""}};
  for (int i = 0; i < 100; ++i) {
    many.push_back({"never moves", "o" + std::to_string(i), "stands still", "see `frame:`"});
  }
  many.push_back({"size", "rover", "is 390 m long", ""});
  EXPECT_THAT(
      messagesOf(many),
      ::testing::ElementsAre("pictures: are dark",
                             AllOf(StartsWith("o0: stands still (likewise 99 more: o1, o2, o3,"),
                                   HasSubstr("o10 and 89 more)"), EndsWith("; see `frame:`")),
                             "rover: is 390 m long"));
}

}  // namespace finding_test
}  // namespace synthetic_dataset::run

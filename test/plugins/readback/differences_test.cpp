#include "plugins/readback/differences.h"

#include <gmock/gmock.h>

namespace synthetic_dataset::formats {
namespace differences_test {

using nlohmann::json;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> differencesOf(const json& found, const json& right) {
  Differences differences;
  compareJson(found, right, "file", differences);
  return differences.lines();
}

std::vector<std::string> differencesOfText(const std::string& found, const std::string& right) {
  Differences differences;
  compareText(found, right, "file", differences);
  return differences.lines();
}

TEST(JsonDifferences, AreNoneBetweenNumbersThatLostTheirLastDigits) {
  EXPECT_THAT(differencesOf({{"a", {1.0000000001, 2}}, {"b", 3}}, {{"a", {1.0, 2}}, {"b", 3.0}}),
              IsEmpty());
}

TEST(JsonDifferences, NameTheValueAndWhatItShouldBe) {
  EXPECT_THAT(differencesOf({{"a", {1.0, 2}}}, {{"a", {1.0, 3}}}),
              ElementsAre("file/a/1: found 2; it should be 3"));
  EXPECT_THAT(differencesOf({{"a", "x"}}, {{"a", "y"}}),
              ElementsAre(R"(file/a: found "x"; it should be "y")"));
  EXPECT_THAT(differencesOf({{"a", 1.0}}, {{"a", 1}}),
              ElementsAre("file/a: found 1.0; it should be 1"));
}

TEST(JsonDifferences, AreValuesThatLackAndValuesThatNobodyKnows) {
  EXPECT_THAT(differencesOf({{"more", 1}}, {{"a", 1}}),
              ElementsAre("file: 'a' is missing", "file: found 'more', which should not be there"));
  EXPECT_THAT(differencesOf({1, 2, 3}, {1, 2}),
              ElementsAre("file: found 3 entries; it should be 2"));
}

TEST(JsonDifferences, OfManyNameTheFirst) {
  EXPECT_THAT(differencesOf({1, 2, 3, 4, 5}, {2, 3, 4, 5, 6}).back(), "2 more values are wrong");
}

TEST(TextDifferences, AreNoneWithinOneOfTheLastDecimal) {
  EXPECT_THAT(differencesOfText("cup 0.12346 -0.00000\n", "cup 0.12345 0.00000\n"), IsEmpty());
}

TEST(TextDifferences, NameTheLine) {
  EXPECT_THAT(differencesOfText("a 1\ncup 0.12347\n", "a 1\ncup 0.12345\n"),
              ElementsAre("file, line 2: found '0.12347'; it should be '0.12345'"));
  EXPECT_THAT(differencesOfText("a 2\n", "a 1\n"),
              ElementsAre("file, line 1: found '2'; it should be '1'"));
  EXPECT_THAT(differencesOfText("a\nb\n", "a\n"),
              ElementsAre("file: found 2 lines; it should be 1"));
}

}  // namespace differences_test
}  // namespace synthetic_dataset::formats

#include "plugins/readback/differences.h"

#include <gmock/gmock.h>

#include "support/error_messages.h"

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

TEST(JsonDifferences, RefuseWhatNestsWithoutBound) {
  const std::string deep = std::string(50000, '[') + std::string(50000, ']');
  const auto errorsOf = [&](const std::string& name) {
    return test::messagesOf([&] {
      Differences differences;
      compareContents(deep, "{}", name, differences);
    });
  };
  EXPECT_THAT(errorsOf("camera.json"), ElementsAre("'camera.json': nested deeper than 400 levels"));
  EXPECT_THAT(errorsOf("metadata.jsonl"),
              ElementsAre("'metadata.jsonl': nested deeper than 400 levels"));
  Differences differences;
  compareRecords(deep, "{}", "a record", differences);
  EXPECT_EQ(1U, differences.lines().size());
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

TEST(TextDifferences, TakeAPunctuationMarkForAWordsEnd) {
  EXPECT_THAT(differencesOfText("<x>1.25</x>,b", "<x>1.05</x>,b"),
              ElementsAre("file, line 1: found '1.25'; it should be '1.05'"));
}

TEST(TextDifferences, AreNoneBetweenTheTwoNamesOfHalfATurn) {
  EXPECT_THAT(differencesOfText("-3.141593", "3.141593"), IsEmpty());
  EXPECT_THAT(differencesOfText("-3.131593", "3.131593"), testing::SizeIs(1));
}

TEST(Differences, PassOverWhatNobodyKnows) {
  Differences differences;
  const std::string other = "a 2 z";
  compareText("a 7 z", "a 1 z", "file", differences, &other);
  EXPECT_TRUE(differences.empty());
  compareText("b 7 z", "a 1 z", "file", differences, &other);
  EXPECT_THAT(differences.lines(), ElementsAre("file, line 1: found 'b'; it should be 'a'"));
}

TEST(Differences, OfFilesAreLookedForInTheWayOfTheirKind) {
  const auto differ = [](const std::string& found, const std::string& right,
                         const std::string& name) {
    Differences differences;
    compareContents(found, right, name, differences);
    return !differences.empty();
  };
  EXPECT_FALSE(differ("[1.0000000001]", "[ 1.0 ]", "x.json"));
  EXPECT_TRUE(differ("{\"a\": 1}\n{\"a\": 2}\n", "{\"a\": 1}\n{\"a\": 3}\n", "x.jsonl"));
  EXPECT_TRUE(differ(std::string("a\0b", 3), std::string("a\0c", 3), "x.bin"));
}

TEST(Differences, OfRecordsThatAreNoTextMayBeTheLastDigitsOfNumbers) {
  const auto record = [](double number) {
    std::string bytes("id\0", 3);
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    return bytes + "end";
  };
  Differences differences;
  compareRecords(record(0.30000000000000004), record(0.3), "record", differences);
  EXPECT_TRUE(differences.empty());
  compareRecords(record(0.31), record(0.3), "record", differences);
  EXPECT_FALSE(differences.empty());
}

}  // namespace differences_test
}  // namespace synthetic_dataset::formats

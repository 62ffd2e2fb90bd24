#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/json_text.h"
#include "support/error_messages.h"

namespace synthetic_dataset::base {
namespace {

TEST(JsonValue, ReadsWhatBrowsersWrite) {
  EXPECT_EQ(Value(1e-7), parseJson("1e-7", "x"));  // a string in YAML 1.1
  EXPECT_EQ(Value(3), parseJson("3", "x"));
  EXPECT_EQ(Value(1.8446744073709552e19), parseJson("18446744073709551615", "x"));
  EXPECT_EQ(Value("yes"), parseJson("\"yes\"", "x"));
  EXPECT_EQ(Value("\xF0\x9F\x98\x80/"), parseJson("\"\\ud83d\\ude00\\/\"", "x"));
  EXPECT_EQ(Value(Value::Map{{"a", Value(Value::List{Value(), Value(true)})}}),
            parseJson("{\"a\": [null, true]}", "x"));
}

TEST(JsonValue, IsTheOtherWayRoundOfStrictJson) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ("[\".inf\", \"-.inf\", 0.5]",
            strictJsonText(Value::List{Value(infinity), Value(-infinity), Value(0.5)}));
  EXPECT_EQ(Value(-infinity), parseJson("\"-.inf\"", "x"));
  EXPECT_TRUE(std::isnan(*parseJson("\".nan\"", "x").as<double>()));
  EXPECT_EQ("\"\\\\xe4\"", strictJsonText(Value("\xE4")));  // not UTF-8
}

TEST(JsonValue, NamesWhatIsNoJson) {
  const auto messages = test::messagesOf([] { (void)parseJson("{a: 1}", "the request"); });
  ASSERT_EQ(1U, messages.size());
  EXPECT_EQ(0U, messages.front().find("the request: cannot be read as JSON: "));
}

TEST(JsonValue, RefusesWhatNestsWithoutBound) {
  const auto errorsOf = [](const std::string& text) {
    return test::messagesOf([&] { (void)parseJson(text, "the request"); });
  };
  const std::vector<std::string> refusal = {"the request: nested deeper than 400 levels"};
  EXPECT_EQ(refusal, errorsOf(std::string(20000, '[') + std::string(20000, ']')));
  EXPECT_EQ(refusal, errorsOf(std::string(401, '[') + std::string(401, ']')));
  std::string groups;
  for (int i = 0; i < 10000; ++i) groups += "{\"]\\\"]\": ";  // with brackets in their names
  EXPECT_EQ(refusal, errorsOf(groups));
  EXPECT_TRUE(errorsOf(std::string(400, '[') + std::string(400, ']')).empty());
  EXPECT_TRUE(errorsOf("\"" + std::string(20000, '[') + "\"").empty());
}

}  // namespace
}  // namespace synthetic_dataset::base

#include "base/json_text.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "base/yaml_value.h"

namespace synthetic_dataset::base {
namespace json_text_test {

Value roundTrip(const Value& value) { return parseYaml(jsonText(value), "test"); }

TEST(JsonText, IsJson) {
  EXPECT_EQ(jsonText(Value(true)), "true");
  EXPECT_EQ(jsonText(Value(3)), "3");
  EXPECT_EQ(jsonText(Value(0.5)), "0.5");
  EXPECT_EQ(jsonText(Value("a \"b\" \\ \n")), "\"a \\\"b\\\" \\\\ \\u000a\"");
  EXPECT_EQ(jsonText(Value(Value::List{Value(1), Value("x")})), "[1, \"x\"]");
  EXPECT_EQ(jsonText(Value(Value::Map{{"a", Value(1)}})), "{\"a\": 1}");
}

TEST(JsonText, ReadsBackAsTheSameValue) {
  for (const Value& value :
       {Value(true), Value(-7), Value(std::int64_t{1} << 62), Value(0.1), Value(1e-05),
        Value(1e300), Value(2.0), Value("yes"), Value("007"), Value("1e-05"), Value(""),
        Value("\xC3\xA4 \t#: {"), Value(Value::List{}),
        Value(Value::List{Value(Value::Map{{"a b", Value(1.5)}})})}) {
    EXPECT_EQ(roundTrip(value), value) << jsonText(value);
  }
  EXPECT_EQ(roundTrip(Value(std::numeric_limits<double>::infinity())),
            Value(std::numeric_limits<double>::infinity()));
  EXPECT_TRUE(std::isnan(*roundTrip(Value(std::nan(""))).as<double>()));
}

}  // namespace json_text_test
}  // namespace synthetic_dataset::base

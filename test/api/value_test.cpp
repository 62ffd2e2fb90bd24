#include "synthetic_dataset/value.h"

#include <gtest/gtest.h>

namespace synthetic_dataset {
namespace value_test {

TEST(Value, ScalarsReadAsPythonPrintsThem) {
  EXPECT_EQ(Value(3).text(), "3");
  EXPECT_EQ(Value(2.5).text(), "2.5");
  EXPECT_EQ(Value(1.0).text(), "1.0");
  EXPECT_EQ(Value(-0.0).text(), "-0.0");
  EXPECT_EQ(Value(0.1).text(), "0.1");
  EXPECT_EQ(Value(1e16).text(), "1e+16");
  EXPECT_EQ(Value(123456789012345.0).text(), "123456789012345.0");
  EXPECT_EQ(Value(0.0001).text(), "0.0001");
  EXPECT_EQ(Value(0.00001).text(), "1e-05");
  EXPECT_EQ(Value(true).text(), "True");
  EXPECT_EQ(Value("fork lift").text(), "fork lift");
  EXPECT_EQ(Value("007").text(), "007");
}

TEST(Value, TreesReadAsFlowStyleYaml) {
  const Value tree = Value::Map{{"a", Value::List{Value(1), Value("x")}}, {"b", Value()}};
  EXPECT_EQ(tree.text(), "{a: [1, x], b: null}");
}

TEST(Value, TellsItsKind) {
  EXPECT_EQ(Value(1).kind(), "a whole number");
  EXPECT_EQ(Value(1.5).kind(), "a number");
  EXPECT_EQ(Value(Value::List{}).kind(), "a list");
  EXPECT_EQ(Value().kind(), "nothing");
}

}  // namespace value_test
}  // namespace synthetic_dataset

#include "config/yaml_value.h"

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::config {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Value scalar(const std::string& text) {
  return parseYaml("key: " + text, "test").as<Value::Map>()->at("key");
}

TEST(ParseYaml, ResolvesScalarsAsRoslaunchDoes) {
  EXPECT_EQ(scalar("3"), Value(3));
  EXPECT_EQ(scalar("010"), Value(8));
  EXPECT_EQ(scalar("0x1F"), Value(31));
  EXPECT_EQ(scalar("-12"), Value(-12));
  EXPECT_EQ(scalar("2.50"), Value(2.5));
  EXPECT_EQ(scalar("1e5"), Value("1e5"));
  EXPECT_EQ(scalar("1.0e+5"), Value(1e5));
  EXPECT_EQ(scalar("yes"), Value(true));
  EXPECT_EQ(scalar("Off"), Value(false));
  EXPECT_EQ(scalar("\"007\""), Value("007"));
  EXPECT_EQ(scalar("'true'"), Value("true"));
  EXPECT_EQ(scalar("fork lift"), Value("fork lift"));
  EXPECT_EQ(scalar("~"), Value());
}

TEST(ParseYaml, KeepsListsAndGroups) {
  EXPECT_EQ(parseYaml("a: [1, [2, 3]]\nb: {c: x}", "test"),
            Value(Value::Map{{"a", Value::List{Value(1), Value::List{Value(2), Value(3)}}},
                             {"b", Value::Map{{"c", Value("x")}}}}));
}

TEST(ParseYaml, NamesFileAndLineOfAMistake) {
  EXPECT_THAT([] { return parseYaml("a: 1\nb: [1, 2\nc: }", "my.yaml"); },
              ThrowsMessage<Error>(HasSubstr("my.yaml: line 3")));
}

TEST(ParseYaml, RefusesWhatNestsWithoutBound) {
  EXPECT_THAT([] { return parseYaml(std::string(100, '[') + std::string(100, ']'), "my.yaml"); },
              ThrowsMessage<Error>(HasSubstr("nested deeper")));
}

TEST(LoadYamlFile, NamesAFileThatIsMissing) {
  EXPECT_THAT([] { return loadYamlFile("/nowhere/params.yaml"); },
              ThrowsMessage<Error>(HasSubstr("/nowhere/params.yaml: no such file")));
}

}  // namespace
}  // namespace synthetic_dataset::config

#include "base/yaml_value.h"

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace yaml_value_test {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

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
  EXPECT_THAT(test::messagesOf([] { return parseYaml("a: 1\nb: [1, 2\nc: }", "my.yaml"); }),
              testing::ElementsAre(HasSubstr("my.yaml: line 3")));
}

TEST(ParseSettings, RemarksASecondGroupOfAName) {
  const std::string text = "camera:\n  near: 0.1\nseed: 1\ncamera:\n  far: 9.0\n";
  std::vector<std::string> remarks;
  const auto note = [&](const std::string& remark) { remarks.push_back(remark); };
  EXPECT_EQ(parseSettings(text, "my.yaml", note),
            parseSettings("{seed: 1, camera: {far: 9.0}}", ""))
      << "as PyYAML has it";
  EXPECT_THAT(remarks, testing::ElementsAre("my.yaml: line 4: found 'camera' a second time; its "
                                            "value in line 1 is ignored"));
  (void)parseSettings("a: &a {x: 1, y: 1}\nb: {<<: *a, x: 2}", "test", note);
  EXPECT_EQ(remarks.size(), 1U) << "what is merged may be set anew";
}

TEST(ParseYaml, RefusesAQuoteThatIsNotClosed) {
  for (const std::string text : {"a: \"x\n", "a: 'x\n", "a: \"x", "a: 'x", "a: \"x\n\n  y\n"}) {
    EXPECT_THROW((void)parseYaml(text, "my.yaml"), Error) << text;
  }
}

TEST(ParseYaml, KeepsWhatEndsWithTheFile) {
  EXPECT_EQ(scalar("|\n  x\n"), Value("x\n"));
  EXPECT_EQ(scalar("|\n  x"), Value("x"));
  EXPECT_EQ(scalar("|+\n  x\n\n"), Value("x\n\n"));
  EXPECT_EQ(scalar("x\n..."), Value("x"));
}

TEST(ParseYaml, RefusesWhatNestsWithoutBound) {
  const auto errorsOf = [](const std::string& text) {
    return test::messagesOf([&] { return parseYaml(text, "my.yaml"); });
  };
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
  };
  EXPECT_THAT(errorsOf(nested(400)), testing::IsEmpty());
  EXPECT_THAT(errorsOf(nested(401)), testing::ElementsAre(HasSubstr("nested deeper")));
  EXPECT_THAT(errorsOf(nested(50000)), testing::ElementsAre(HasSubstr("nested deeper")));
  EXPECT_THAT(errorsOf(std::string(50000, '[')), testing::ElementsAre(HasSubstr("nested deeper")));
  std::string dashes;
  for (int i = 0; i < 2000; ++i) dashes += "- ";
  EXPECT_THAT(errorsOf(dashes + "x"), testing::ElementsAre(HasSubstr("nested deeper")));
  EXPECT_THAT(errorsOf("&a [*a]"), testing::ElementsAre(HasSubstr("does it contain itself?")));
}

TEST(ParseYaml, MergesGroups) {
  EXPECT_EQ(parseYaml("a: &a {x: 1, y: 1}\nb: &b {y: 2, z: 2}\n"
                      "c: {y: 3, <<: *a}\nd: {<<: [*a, *b]}\ne: {'<<': 1}",
                      "test"),
            Value(Value::Map{{"a", Value::Map{{"x", 1}, {"y", 1}}},
                             {"b", Value::Map{{"y", 2}, {"z", 2}}},
                             {"c", Value::Map{{"x", 1}, {"y", 3}}},
                             {"d", Value::Map{{"x", 1}, {"y", 1}, {"z", 2}}},
                             {"e", Value::Map{{"<<", 1}}}}));
}

TEST(ParseYaml, PassesOverForeignTags) {
  EXPECT_EQ(parseYaml("a: !!opencv-matrix {rows: 1}\nb: !mine 2\nc: 2001-01-01", "test"),
            Value(Value::Map{{"a", Value::Map{{"rows", 1}}}, {"b", 2}, {"c", "2001-01-01"}}));
}

TEST(ParseYaml, RefusesAliasesThatMultiply) {
  std::string text = "a0: &a0 [x, x, x, x, x, x, x, x]\n";
  std::string merged = "a0: &a0 {a: 1, b: 1}\n";
  for (int i = 1; i < 30; ++i) {
    const std::string name = "a" + std::to_string(i);
    const std::string before = "*a" + std::to_string(i - 1);
    text += name + ": &" + name + " [" + before + ", " + before + "]\n";
    merged += name + ": &" + name + " {<<: [" + before + ", " + before + "]}\n";
  }
  for (const std::string& file : {text, merged}) {
    EXPECT_THAT(test::messagesOf([&] { return parseYaml(file, "test"); }),
                testing::ElementsAre(HasSubstr("its aliases multiply")));
  }
}

Value setting(const std::string& text) {
  return parseSettings("key: " + text, "test").as<Value::Map>()->at("key");
}

TEST(ParseSettings, ReadsAnglesAsRosparamDoes) {
  constexpr double kPi = 3.141592653589793;
  EXPECT_EQ(setting("deg(180)"), Value(kPi));
  EXPECT_EQ(setting("rad(pi/2)"), Value(kPi / 2));
  EXPECT_EQ(setting("!degrees 90"), Value(kPi / 2));
  EXPECT_EQ(setting("!radians (1+1)*pi"), Value(2 * kPi));
  EXPECT_EQ(setting("'deg(180)'"), Value("deg(180)"));
  EXPECT_EQ(setting("rad((1+1)*pi)"), Value("rad((1+1)*pi)"));
}

TEST(ParseSettings, FollowsTags) {
  EXPECT_EQ(setting("!!str 3"), Value("3"));
  EXPECT_EQ(setting("!!float 3"), Value(3.0));
  EXPECT_EQ(setting("!!int '3'"), Value(3));
  EXPECT_EQ(setting("!!bool 'yes'"), Value(true));
}

TEST(ParseSettings, RefusesWhatTheParameterServerCannotHold) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"a: 1\nb:\n", "found nothing (null)"},
      {"a: [1, ~]", "line 1: found nothing (null)"},
      {"a: 2001-01-01", "found the date 2001-01-01"},
      {"a: !!binary aGVsbG8=", "found !!binary 'aGVsbG8='"},
      {"a: !!set {x: 1}", "found !!set"},
      {"a: !mine 3", "found !mine '3'"},
      {"a: !!int x", "found !!int 'x'"},
      {"1: 2", "found the name 1, which"},
      {"yes: 2", "found the name yes, which"},
      {"a: deg(x)", "found the angle 'x'"},
      {"a: 1\n---\nb: 2", "a second document"},
      {", a", "a second document"},  // yaml-cpp's LoadAll would find endless documents
      {"a: 1\n}", "illegal flow end"}};
  for (const auto& each : cases) {
    EXPECT_THAT(test::messagesOf([&] { return parseSettings(each.first, "test"); }),
                testing::ElementsAre(HasSubstr(each.second)))
        << each.first;
  }
}

TEST(ParseSettings, NameATabAndItsLine) {
  for (const std::string text : {"world: a\ncamera:\n\tinfo_file: b\n",
                                 "world: a\ncamera:\n  \tinfo_file: b\n\tnear: 1\n"}) {
    EXPECT_THAT(test::messagesOf([&] { (void)parseSettings(text, "my.yaml"); }),
                ElementsAre(HasSubstr("my.yaml: line 3: found a tab in the indentation; YAML takes "
                                      "spaces")))
        << text;
  }
  EXPECT_EQ(parseSettings("a: 1  # with\ttabs\n#\there\n", "my.yaml"),
            Value(Value::Map{{"a", Value(1)}}));
}

TEST(ParseSettings, AskForTheIndentationWhereItIsWrong) {
  EXPECT_THAT(
      test::messagesOf([] { (void)parseSettings("camera:\n  near: 1\n    far: 2\n", "my.yaml"); }),
      ElementsAre(
          AllOf(HasSubstr("my.yaml: line 3"), HasSubstr("is the line indented like the others "
                                                        "of its group"))));
}

TEST(ParseYaml, ComesToAnEndWithAStrayComma) {
  EXPECT_EQ(parseYaml(",1_005tr _005tr 1, n: ~}\n", "my.yaml"), Value());
}

TEST(ParseYaml, RefusesAliasesThatMultiplyALongText) {
  std::string text = "a: &a " + std::string(10000, 'x') + "\nb: [*a";
  for (int i = 0; i < 2000; ++i) text += ", *a";  // 20 million letters
  EXPECT_THAT(test::messagesOf([&] { return parseYaml(text + "]", "my.yaml"); }),
              testing::ElementsAre(HasSubstr("its aliases multiply")));
}

TEST(ParseYaml, TakesADigitAMillionTimesForAText) {
  const std::string digits(1000000, '1');
  EXPECT_EQ(scalar(digits), Value(digits));
}

TEST(LoadYamlFile, NamesAFileThatIsMissing) {
  EXPECT_THAT(test::messagesOf([] { return loadYamlFile("/nowhere/params.yaml"); }),
              testing::ElementsAre(HasSubstr("/nowhere/params.yaml: no such file")));
}

}  // namespace yaml_value_test
}  // namespace synthetic_dataset::base

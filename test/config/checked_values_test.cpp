#include "config/checked_values.h"

#include <gmock/gmock.h>

#include "config/config.h"

namespace synthetic_dataset::config {
namespace checked_values_test {

using testing::Contains;
using testing::HasSubstr;

TEST(NameProblem, AllowsWhateverOneCanRead) {
  for (const std::string& name :
       {std::string("fork lift"), std::string("\"a\" & <b>, c: {d}"), std::string("../.."),
        std::string("\u00e4\u2615\U0001F916"), std::string(300, 'n')}) {
    EXPECT_EQ(nameProblem(name), std::nullopt) << name;
  }
}

TEST(NameProblem, NamesWhatBreaksLinesAndFormats) {
  EXPECT_EQ(nameProblem(""), "is empty");
  EXPECT_EQ(nameProblem("a\nb"), "has more than one line");
  EXPECT_EQ(nameProblem("a\x01"), "has a control character");
  EXPECT_EQ(nameProblem(std::string("a\0b", 3)), "has a control character");
  EXPECT_EQ(nameProblem("\x7F"), "has a control character");
}

TEST(NameProblem, NamesWhatIsNotUtf8) {
  for (const std::string name :
       {"\xFF", "\xC3", "\xC0\xAF", "\xE2\x98", "\xED\xA0\x80", "\xF4\x90\x80\x80", "a\x80"}) {
    EXPECT_EQ(nameProblem(name), "is not UTF-8");
  }
}

TEST(NameProblem, IsToldOfObjectsClassesIdsAndKeypoints) {
  Parameters root(Value::Map{
      {"robot_list", Value::List{Value("a\tb"), Value("good")}},
      {"classes", Value::List{Value("c\x02")}},
      {"good",
       Value::Map{{"class", Value("c\x02")},
                  {"id", Value("i\xFF")},
                  {"keypoints", Value::List{Value(Value::List{Value(0), Value(0), Value(0)})}},
                  {"keypoint_names", Value::List{Value("k\x1F")}}}}});
  static_cast<void>(readConfig(root));
  EXPECT_THAT(root.errors(), Contains("robot_list: found a name that has a control character"));
  EXPECT_THAT(root.errors(), Contains("classes: found a name that has a control character"));
  EXPECT_THAT(root.errors(), Contains("good/id: found a text that is not UTF-8"));
  EXPECT_THAT(root.errors(),
              Contains(HasSubstr("keypoint_names: found a name that has a control")));
}

}  // namespace checked_values_test
}  // namespace synthetic_dataset::config

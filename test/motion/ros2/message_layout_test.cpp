#include "motion/ros2/message_layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/bag/known_messages.h"
#include "motion/recorded.h"
#include "motion/ros2_bags.h"

namespace synthetic_dataset::motion {
namespace message_layout_test {

using ::testing::HasSubstr;

std::vector<std::string> namesOf(const MessageLayout& layout) {
  std::vector<std::string> names;
  for (const FieldLayout& field : layout.fields) names.push_back(field.name);
  return names;
}

std::string errorOf(const std::string& definition) {
  return messageOf([&] { (void)parseLayout("a/A", definition); });
}

TEST(MessageLayout, TakesFieldsAndPassesOverAllElse) {
  const auto layout = parseLayout("a/A", R"(# a comment = 1
uint8 LOW=1
string NAME = "x=y"
byte[] data      # more
float64[9] k
string<=5[<=3] words
int32 count 7
string greeting "a=b"
)");
  EXPECT_THAT(namesOf(*layout), ::testing::ElementsAre("data", "k", "words", "count", "greeting"));
  EXPECT_EQ(layout->fields[0].type, "uint8");
  EXPECT_EQ(layout->fields[1].fixed_count, 9U);
  EXPECT_EQ(layout->fields[2].count, FieldLayout::Count::kList);
  EXPECT_EQ(layout->least_size, 4U + 72U + 4U + 4U + 4U);
}

TEST(MessageLayout, TheRecordedDefinitionIsTheKnownOne) {
  const auto recorded = parseLayout("tf2_msgs/TFMessage", kTransformsDefinition);
  EXPECT_EQ(differenceOf(*recorded, *knownMessage("tf2_msgs/TFMessage")->layout), "");
}

TEST(MessageLayout, NamesTheFirstFieldThatDiffers) {
  std::string definition = kTransformsDefinition;
  definition.replace(definition.find("float64 y"), 9, "float32 y");
  const auto recorded = parseLayout("tf2_msgs/TFMessage", definition);
  EXPECT_EQ(differenceOf(*recorded, *knownMessage("tf2_msgs/TFMessage")->layout),
            "geometry_msgs/Vector3 has 'float32 y' for 'float64 y'");
}

TEST(MessageLayout, NamesWhatIsMissingOrEndless) {
  EXPECT_THAT(errorOf("b/B inner\n"), HasSubstr("lacks the type b/B"));
  EXPECT_THAT(errorOf("A inner\n"), HasSubstr("has a/A within itself"));
  EXPECT_THAT(errorOf("float64[\n"), HasSubstr("'float64['"));
  EXPECT_THAT(errorOf("float64[0] x\n"), HasSubstr("'float64[0]'"));
  EXPECT_THAT(errorOf("wstring name\n"), HasSubstr("wide texts"));
}

TEST(MessageLayout, RefusesSizesThatGrowWithEachType) {
  std::string definition = "B0[1000] x\n";
  for (int i = 0; i < 8; ++i) {
    definition +=
        "====\nMSG: a/B" + std::to_string(i) + "\nB" + std::to_string(i + 1) + "[1000] x\n";
  }
  EXPECT_THAT(errorOf(definition + "====\nMSG: a/B8\nuint8 x\n"), HasSubstr("too long to be one"));
}

}  // namespace message_layout_test
}  // namespace synthetic_dataset::motion

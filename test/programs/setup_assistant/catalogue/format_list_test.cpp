#include "programs/setup_assistant/catalogue/format_list.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "plugins/readback/format.h"

namespace synthetic_dataset::programs {
namespace {

const Value::List& formatsIn(const Value& list) {
  return *list.as<Value::Map>()->at("formats").as<Value::List>();
}

std::string textOfMember(const Value& group, const std::string& name) {
  return group.as<Value::Map>()->at(name).text();
}

TEST(FormatList, HasEachFormatOfThisPackage) {
  const Value list = formatList(formatsDocument());
  std::set<std::string> types;
  for (const Value& each : formatsIn(list)) {
    types.insert(textOfMember(each, "type"));
    EXPECT_NE("", textOfMember(each, "text")) << textOfMember(each, "type");
  }
  for (const auto& [name, type] : formats::formatNames()) EXPECT_EQ(1U, types.count(type)) << type;
  EXPECT_EQ(formats::formatNames().size(), types.size());
}

TEST(FormatList, HasTheSettingsOfAFormatsTables) {
  const Value list = formatList(
      "| type | what it makes | read by |\n| --- | --- | --- |\n"
      "| [`synthetic_dataset/Yolo`](#darknet-yolo) | images | Darknet |\n\n"
      "## Darknet YOLO\n\n| file | |\n| --- | --- |\n| `a.txt` | labels |\n\n"
      "| setting | |\n| --- | --- |\n| `main_list` | required: the list |\n"
      "| `quality` | how good (`95`) |\n\n## Other\n\n| setting | |\n| `no` | none |\n");
  ASSERT_EQ(1U, formatsIn(list).size());
  const Value& yolo = formatsIn(list).front();
  EXPECT_EQ("yolo", textOfMember(yolo, "name"));
  EXPECT_EQ("Darknet", textOfMember(yolo, "read_by"));
  const auto& options = *yolo.as<Value::Map>()->at("options").as<Value::List>();
  ASSERT_EQ(2U, options.size());
  EXPECT_EQ("main_list", textOfMember(options[0], "name"));
  EXPECT_EQ("95", textOfMember(options[1], "default"));
}

}  // namespace
}  // namespace synthetic_dataset::programs

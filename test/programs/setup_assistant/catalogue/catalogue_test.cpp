#include "programs/setup_assistant/catalogue/catalogue.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "plugins/readback/format.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::programs {
namespace catalogue_test {

Value member(const Value& group, const std::string& name) {
  const auto& map = *group.as<Value::Map>();
  const auto found = map.find(name);
  return found == map.end() ? Value() : found->second;
}

/// The entry of a list whose member `name` is this text.
Value entryIn(const Value& list, const std::string& name, const std::string& text) {
  for (const Value& each : *list.as<Value::List>()) {
    if (member(each, name) == Value(text)) return each;
  }
  ADD_FAILURE() << "no " << text;
  return Value::Map{};
}

TEST(ParameterList, HasChoicesUnitsAndWhatIsRequired) {
  const Value list = member(parameterList(), "parameters");
  const auto parameter = [&](const std::string& path) { return entryIn(list, "path", path); };
  EXPECT_EQ(member(parameter("motion"), "choices"), Value(Value::List{"bag", "placement"}));
  EXPECT_EQ(member(parameter("simulated_rate"), "unit"), Value("Hz"));
  EXPECT_EQ(member(parameter("simulated_rate"), "default"), Value(30.0));
  EXPECT_EQ(member(parameter("bag_file"), "required"), Value(true));
  EXPECT_EQ(member(parameter("yolo/cut_to_image"), "default"), Value(true));
  EXPECT_EQ(member(parameter("twin/depth_margin"), "default"), Value(0.1));
}

TEST(FormatList, HasEachFormatOfThisPackage) {
  const Value list = member(formatList(), "formats");
  EXPECT_EQ(list.as<Value::List>()->size(), formats::formatNames().size());
  for (const auto& [name, type] : formats::formatNames()) {
    EXPECT_NE(member(entryIn(list, "type", type), "text"), Value("")) << type;
  }
}

TEST(FormatList, HasTheSettingsOfAFormatsTablesAndWhatItsWriterDeclares) {
  test::preparePluginEnvironment();
  const Value list = member(formatList(), "formats");
  const Value yolo = entryIn(list, "name", "yolo");
  EXPECT_EQ(member(yolo, "read_by"), Value("Darknet"));
  const Value of_class = entryIn(member(yolo, "options"), "name", "class");
  EXPECT_EQ(member(of_class, "default"), Value("text"));
  EXPECT_EQ(member(of_class, "choices"), Value(Value::List{"text", "number"}));
  const Value bop = member(entryIn(list, "name", "bop"), "options");
  EXPECT_EQ(member(entryIn(bop, "name", "images_per_scene"), "default"), Value(1000));
}

/// docs/formats.md describes KITTI's settings once, as its tracking format has the same.
TEST(FormatList, HasATableWithEverySettingThatAWriterDeclares) {
  test::preparePluginEnvironment();
  const Value list = member(formatList(), "formats");
  for (const Value& format : *list.as<Value::List>()) {
    if (member(format, "name") == Value("kitti_tracking")) continue;
    const Value options = member(format, "options");
    for (const Value& option : *options.as<Value::List>()) {
      EXPECT_NE(member(option, "text"), Value("")) << format.text();
    }
  }
}

}  // namespace catalogue_test
}  // namespace synthetic_dataset::programs

#include "programs/setup_assistant/catalogue/parameter_list.h"

#include <string>

#include <gtest/gtest.h>

namespace synthetic_dataset::programs {
namespace {

Value::Map parameterAt(const std::string& path) {
  const Value list = parameterList();
  for (const Value& each : *list.as<Value::Map>()->at("parameters").as<Value::List>()) {
    if (each.as<Value::Map>()->at("path") == Value(path)) return *each.as<Value::Map>();
  }
  return {};
}

TEST(ParameterList, HasChoicesUnitsAndWhatIsRequired) {
  EXPECT_EQ(Value(Value::List{Value("bag"), Value("placement")}),
            parameterAt("motion").at("choices"));
  EXPECT_EQ(Value("Hz"), parameterAt("simulated_rate").at("unit"));
  EXPECT_EQ(Value(30.0), parameterAt("simulated_rate").at("default"));
  EXPECT_EQ(Value(true), parameterAt("bag_file").at("required"));
  EXPECT_EQ(Value(true), parameterAt("yolo/cut_to_image").at("default"));
}

}  // namespace
}  // namespace synthetic_dataset::programs

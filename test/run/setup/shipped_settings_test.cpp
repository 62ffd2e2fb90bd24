/// The settings files of config/, as users load them.

#include <cstdlib>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include "config/settings_file.h"
#include "run/check/run_check.h"
#include "run/setup/run_setup.h"
#include "run/setup/transfer_preset.h"
#include "support/error_messages.h"
#include "support/source_folder.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::run {
namespace shipped_settings_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Value::Map shipped(const std::string& name) {
  return config::loadSettings(test::sourceFolder() + "/config/" + name,
                              [](const std::string&) { return test::sourceFolder(); });
}

/// Sets another HOME during its lifetime.
class HomeElsewhere {
 public:
  explicit HomeElsewhere(const char* home) {
    if (const char* given = std::getenv("HOME")) before_ = given;
    ::setenv("HOME", home, 1);
  }
  ~HomeElsewhere() { before_ ? ::setenv("HOME", before_->c_str(), 1) : ::unsetenv("HOME"); }
  HomeElsewhere(const HomeElsewhere&) = delete;
  HomeElsewhere& operator=(const HomeElsewhere&) = delete;

 private:
  std::optional<std::string> before_;
};

std::vector<std::string> errorsOf(const Value::Map& settings) {
  test::preparePluginEnvironment();
  return test::messagesOf(
      [&] { static_cast<void>(setUpRun(Value(settings), {test::pluginXml()})); });
}

TEST(ShippedSettings, OfParamsLackNothingButTheirFiles) {
  const HomeElsewhere home("/nowhere");
  EXPECT_THAT(errorsOf(shipped("params.yaml")),
              ElementsAre(HasSubstr("/nowhere/recording.bag"), HasSubstr("/nowhere/hall.world"),
                          HasSubstr("/nowhere/camera.yaml")));
}

TEST(ShippedSettings, OfTheExamplesAreRight) {
  EXPECT_THAT(errorsOf(shipped("example.yaml")), IsEmpty());
  EXPECT_THAT(errorsOf(shipped("example_placement.yaml")), IsEmpty());
  EXPECT_THAT(errorsOf(shipped("example_motions.yaml")), IsEmpty());
  EXPECT_THAT(errorsOf(shipped("example_twin.yaml")), IsEmpty());
}

TEST(ShippedSettings, OfThePresetGoBelowAnyOthers) {
  Value::Map settings = shipped("randomize_default.yaml");
  config::overlay(settings, shipped("example.yaml"));
  EXPECT_THAT(errorsOf(settings), IsEmpty());
}

/// The least value that an entry can draw; the mean of a normal distribution without bounds.
Value leastOf(const Value& entry) {
  const auto* map = entry.as<Value::Map>();
  if (map == nullptr) return entry;
  if (map->count("uniform") != 0) return map->at("uniform").as<Value::List>()->front();
  if (map->count("normal") != 0) {
    return map->count("min") != 0 ? map->at("min") : map->at("normal").as<Value::List>()->front();
  }
  Value::Map least;
  for (const auto& [name, value] : *map) least[name] = leastOf(value);
  return Value(least);
}

TEST(ShippedSettings, OfThePresetLeaveTheDarkestSceneVisible) {
  test::preparePluginEnvironment();
  Value::Map settings = shipped("randomize_default.yaml");
  config::overlay(settings, shipped("example.yaml"));
  InputCache inputs;
  settings = *expandPreset(Value(settings), inputs).settings.as<Value::Map>();
  settings["randomize"] = leastOf(settings["randomize"]);
  Value::Map& lights = *settings["randomize"].as<Value::Map>()->at("lights").as<Value::Map>();
  (*lights.at("every").as<Value::Map>())["present"] = Value(0.0);  // all but one are off
  Reporter silent;
  const RunCheck check = checkRun(Value(settings), silent, {test::pluginXml()});
  for (const FinishedScene& each : check.scenes) {
    EXPECT_GT(cv::mean(each.scene.image)[1], 20.0) << each.scene.name;
  }
  for (const Finding& each : check.findings) EXPECT_NE(each.kind, "dark") << each.message();
}

}  // namespace shipped_settings_test
}  // namespace synthetic_dataset::run

/// The settings files of config/, as users load them.

#include <cstdlib>
#include <optional>
#include <string>

#include <gmock/gmock.h>

#include "config/settings_file.h"
#include "run/setup/run_setup.h"
#include "support/error_messages.h"
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

/// Another home for a while.
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
}

TEST(ShippedSettings, OfThePresetGoBelowAnyOthers) {
  Value::Map settings = shipped("randomize_default.yaml");
  config::overlay(settings, shipped("example.yaml"));
  EXPECT_THAT(errorsOf(settings), IsEmpty());
}

}  // namespace shipped_settings_test
}  // namespace synthetic_dataset::run

#include "config/settings_file.h"

#include <string>

#include <gmock/gmock.h>

#include "config/yaml_value.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::config {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;
using Map = Value::Map;

Map parameters(const std::string& yaml) {
  return asParameters(parseSettings(yaml, "test"), "test");
}

std::optional<std::string> noPackage(const std::string& /*name*/) { return std::nullopt; }

TEST(AsParameters, TakesASlashForAGroup) {
  EXPECT_EQ(parameters("yolo/main_list: x\nyolo: {cut: true}\na//b/: 1"),
            (Map{{"yolo", Map{{"main_list", "x"}, {"cut", true}}}, {"a", Map{{"b", 1}}}}));
}

TEST(AsParameters, KeepsSlashesWithinLists) {
  EXPECT_EQ(parameters("a: [{b/c: 1}]"), (Map{{"a", Value::List{Map{{"b/c", 1}}}}}));
}

TEST(AsParameters, DropsEmptyGroups) {
  EXPECT_EQ(parameters("a: {}\nb: {c: {}}\nd: []"), (Map{{"d", Value::List{}}}));
  EXPECT_EQ(parameters(""), Map{});
}

TEST(AsParameters, TakesTheGlobalRobotListWhereThereIsNoOther) {
  EXPECT_EQ(parameters("/robot_list: [a]"), (Map{{"robot_list", Value::List{"a"}}}));
  EXPECT_EQ(parameters("/robot_list: [a]\nrobot_list: [b]"),
            (Map{{"robot_list", Value::List{"b"}}}));
}

TEST(AsParameters, RefusesOtherGlobalNames) {
  EXPECT_THAT([] { return parameters("a: {/b: 1}"); },
              ThrowsMessage<Error>(HasSubstr("test: found the name 'a//b'")));
  EXPECT_THAT([] { return parameters("~b: 1"); },
              ThrowsMessage<Error>(HasSubstr("test: found the name '~b'")));
  EXPECT_THROW((void)parameters("'': 1"), Error);
}

TEST(AsParameters, RefusesNamesGivenTwice) {
  EXPECT_THAT([] { return parameters("a/b: 1\na: {b: 2}"); },
              ThrowsMessage<Error>(HasSubstr("test: 'a/b' is given twice")));
  EXPECT_THAT([] { return parameters("a: 1\na/b: 2"); },
              ThrowsMessage<Error>(HasSubstr("test: found 'a/b', but 'a' has a value of its own")));
}

TEST(AsParameters, RefusesWhatIsNoGroup) {
  EXPECT_THAT([] { return parameters("[1, 2]"); },
              ThrowsMessage<Error>(HasSubstr("test: found a list; it should be a group")));
}

TEST(Overlay, MergesGroupsAndReplacesAllElse) {
  Map settings{{"a", Map{{"x", 1}, {"y", Value::List{1}}}}, {"b", 1}, {"c", 3}};
  overlay(settings, {{"a", Map{{"y", Value::List{2}}}}, {"b", Map{{"z", 2}}}, {"d", 4}});
  EXPECT_EQ(
      settings,
      (Map{{"a", Map{{"x", 1}, {"y", Value::List{2}}}}, {"b", Map{{"z", 2}}}, {"c", 3}, {"d", 4}}));
}

TEST(SettingOf, ReadsYamlBelowAPath) {
  EXPECT_EQ(settingOf("shard/index", "2"), (Map{{"shard", Map{{"index", 2}}}}));
  EXPECT_EQ(settingOf("output_folder", "/data/run 1"), (Map{{"output_folder", "/data/run 1"}}));
  EXPECT_EQ(settingOf("robot_list", "[a, b]"), (Map{{"robot_list", Value::List{"a", "b"}}}));
}

TEST(SettingOf, NamesWhatIsWrong) {
  EXPECT_THAT([] { return settingOf("a", "[1"); },
              ThrowsMessage<Error>(HasSubstr("a:=[1: line 1")));
  EXPECT_THAT([] { return settingOf("a", "~"); },
              ThrowsMessage<Error>(HasSubstr("a:=~: found nothing")));
  EXPECT_THROW((void)settingOf("/a", "1"), Error);
}

TEST(LoadSettings, FillsInReadsAndKeepsLikeTheServer) {
  const test::TemporaryFolder folder;
  const std::string file =
      folder.write("my.yaml", "bag_file: $(dirname)/x.bag\r\nyolo/angle: deg(0)\r\n").string();
  EXPECT_EQ(loadSettings(file, noPackage),
            (Map{{"bag_file", (folder / "x.bag").string()}, {"yolo", Map{{"angle", 0.0}}}}));
}

TEST(LoadSettings, NamesAFileThatCannotBeRead) {
  EXPECT_THAT([] { return loadSettings("/nowhere.yaml", noPackage); },
              ThrowsMessage<Error>(HasSubstr("/nowhere.yaml: no such file")));
  const test::TemporaryFolder folder;
  EXPECT_THROW((void)loadSettings(folder.path().string(), noPackage), Error);
}

}  // namespace
}  // namespace synthetic_dataset::config

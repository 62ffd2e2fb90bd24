#include "config/settings_file.h"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>

#include "base/yaml_value.h"
#include "support/error_messages.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::config {
namespace settings_file_test {

using ::testing::HasSubstr;
using Map = Value::Map;

Map parameters(const std::string& yaml) {
  return asParameters(base::parseSettings(yaml, "test"), "test");
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
  EXPECT_THAT(test::messagesOf([] { return parameters("a: {/b: 1}"); }),
              testing::ElementsAre(HasSubstr("test: found the name 'a//b'")));
  EXPECT_THAT(test::messagesOf([] { return parameters("~b: 1"); }),
              testing::ElementsAre(HasSubstr("test: found the name '~b'")));
  EXPECT_THROW((void)parameters("'': 1"), Error);
}

TEST(AsParameters, RefusesNamesGivenTwice) {
  EXPECT_THAT(test::messagesOf([] { return parameters("a/b: 1\na: {b: 2}"); }),
              testing::ElementsAre(HasSubstr("test: 'a/b' is given twice")));
  EXPECT_THAT(test::messagesOf([] { return parameters("a: 1\na/b: 2"); }),
              testing::ElementsAre(HasSubstr("test: found 'a/b', but 'a' has a value of its own")));
}

TEST(AsParameters, RefusesWhatIsNoGroup) {
  EXPECT_THAT(test::messagesOf([] { return parameters("[1, 2]"); }),
              testing::ElementsAre(HasSubstr("test: found a list; it should be a group")));
}

TEST(Overlay, MergesGroupsAndReplacesAllElse) {
  Map settings{{"a", Map{{"x", 1}, {"y", Value::List{1}}}}, {"b", 1}, {"c", 3}};
  overlay(settings, {{"a", Map{{"y", Value::List{2}}}}, {"b", Map{{"z", 2}}}, {"d", 4}});
  EXPECT_EQ(
      settings,
      (Map{{"a", Map{{"x", 1}, {"y", Value::List{2}}}}, {"b", Map{{"z", 2}}}, {"c", 3}, {"d", 4}}));
}

TEST(Overlay, ReplacesADistributionByAnother) {
  const auto over = [](const Map& below, const Map& above) {
    Value::Map settings{{"blur", Value(below)}};
    overlay(settings, {{"blur", Value(above)}});
    return settings.at("blur");
  };
  const Map uniform{{"uniform", Value::List{0, 1}}};
  const Map normal{{"normal", Value::List{0, 1}}, {"max", 2}};
  const Map choice{{"choice", Value::List{0, 1}}};
  EXPECT_EQ(over(uniform, normal), Value(normal));
  EXPECT_EQ(over(normal, uniform), Value(uniform));
  EXPECT_EQ(over({{"pictures", "sky"}}, uniform), Value(uniform));
  EXPECT_EQ(over(uniform, {{"pictures", "sky"}}), Value(Map{{"pictures", "sky"}}));
  EXPECT_EQ(over(choice, {{"weights", Value::List{1, 2}}}),
            Value(Map{{"choice", Value::List{0, 1}}, {"weights", Value::List{1, 2}}}));
}

TEST(SettingOf, ReadsYamlBelowAPath) {
  EXPECT_EQ(settingOf("shard/index", "2"), (Map{{"shard", Map{{"index", 2}}}}));
  EXPECT_EQ(settingOf("output_folder", "/data/run 1"), (Map{{"output_folder", "/data/run 1"}}));
  EXPECT_EQ(settingOf("robot_list", "[a, b]"), (Map{{"robot_list", Value::List{"a", "b"}}}));
}

TEST(SettingOf, NamesWhatIsWrong) {
  EXPECT_THAT(test::messagesOf([] { return settingOf("a", "[1"); }),
              testing::ElementsAre(HasSubstr("a:=[1: line 1")));
  EXPECT_THAT(test::messagesOf([] { return settingOf("a", "~"); }),
              testing::ElementsAre(HasSubstr("a:=~: found nothing")));
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
  EXPECT_THAT(test::messagesOf([] { return loadSettings("/nowhere.yaml", noPackage); }),
              testing::ElementsAre(HasSubstr("/nowhere.yaml: no such file")));
  const test::TemporaryFolder folder;
  EXPECT_THROW((void)loadSettings(folder.path().string(), noPackage), Error);
}

TEST(LoadSettings, NamesWhatIsNoText) {
  const test::TemporaryFolder folder;
  const auto errorOf = [&](const std::string& bytes) {
    const std::string file = folder.write("my.yaml", bytes).string();
    return test::messagesOf([&] { return loadSettings(file, noPackage); });
  };
  EXPECT_THAT(errorOf(std::string("\xff\xfe"
                                  "a\0:\0 \0"
                                  "1\0",
                                  10)),
              testing::ElementsAre(HasSubstr("my.yaml: is UTF-16; it should be UTF-8")));
  EXPECT_THAT(errorOf("\x1f\x8b\x08"),
              testing::ElementsAre(HasSubstr("my.yaml: is compressed; `gunzip` unpacks it")));
}

/// Settings files that others include.
class IncludedSettings : public testing::Test {
 protected:
  [[nodiscard]] Map load(const std::string& name, const TextFinder& finder = noPackage) const {
    return loadSettings((folder / name).string(), finder);
  }

  /// The error of loading a file.
  [[nodiscard]] std::string errorOf(const std::string& name) const {
    try {
      (void)load(name);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder / name).string(); }

  test::TemporaryFolder folder;
};

TEST_F(IncludedSettings, CountWhereTheFileHasNoneOfItsOwn) {
  folder.write("below.yaml", "a: 1\nb: 2\nlist: [1, 2, 3]");
  folder.write("my.yaml", "include: below.yaml\nb: 3\nlist: [4]");
  EXPECT_EQ(load("my.yaml"), (Map{{"a", 1}, {"b", 3}, {"list", Value::List{4}}}));
}

TEST_F(IncludedSettings, AreMergedGroupByGroup) {
  folder.write("below.yaml", "camera: {near: 0.1, pose: [1, 2], effects: {blur: 1, noise: 2}}");
  folder.write("my.yaml", "camera: {near: 0.2, effects: {blur: 3}}\ninclude: below.yaml");
  EXPECT_EQ(load("my.yaml"), (Map{{"camera", Map{{"near", 0.2},
                                                 {"pose", Value::List{1, 2}},
                                                 {"effects", Map{{"blur", 3}, {"noise", 2}}}}}}));
}

TEST_F(IncludedSettings, OfALaterFileCountOverThoseOfAnEarlierOne) {
  folder.write("first.yaml", "a: 1\nb: 1\nc: 1\ng: {x: 1, y: 1}");
  folder.write("second.yaml", "b: 2\nc: 2\ng: {y: 2}");
  folder.write("my.yaml", "include: [first.yaml, second.yaml]\nc: 3");
  EXPECT_EQ(load("my.yaml"), (Map{{"a", 1}, {"b", 2}, {"c", 3}, {"g", Map{{"x", 1}, {"y", 2}}}}));
}

TEST_F(IncludedSettings, MayIncludeOthersThemselves) {
  folder.write("lowest.yaml", "a: 1\nb: 1\nc: 1");
  folder.write("middle.yaml", "include: lowest.yaml\nb: 2\nc: 2");
  folder.write("my.yaml", "include: middle.yaml\nc: 3");
  EXPECT_EQ(load("my.yaml"), (Map{{"a", 1}, {"b", 2}, {"c", 3}}));
}

TEST_F(IncludedSettings, AreFoundFromTheFolderOfTheFileThatIncludesThem) {
  folder.write("common/world.yaml", "include: ../deep/lights.yaml\nworld: w");
  folder.write("deep/lights.yaml", "light: sun\nhere: $(dirname)");
  folder.write("runs/my.yaml", "include: ../common/world.yaml");
  const Map settings = load("runs/my.yaml");
  EXPECT_EQ(settings.at("world"), Value("w"));
  EXPECT_EQ(settings.at("light"), Value("sun"));
  EXPECT_TRUE(std::filesystem::equivalent(*settings.at("here").as<std::string>(), folder / "deep"));
}

TEST_F(IncludedSettings, MayBeAnywhereOrInAPackage) {
  const test::TemporaryFolder elsewhere;
  const std::string absolute = elsewhere.write("absolute.yaml", "a: 1").string();
  elsewhere.write("config/preset.yaml", "b: 2");
  folder.write("my.yaml", "include: ['" + absolute + "', $(find presets)/config/preset.yaml]");
  const auto find = [&](const std::string& name) -> std::optional<std::string> {
    if (name != "presets") return std::nullopt;
    return elsewhere.path().string();
  };
  EXPECT_EQ(load("my.yaml", find), (Map{{"a", 1}, {"b", 2}}));
}

TEST_F(IncludedSettings, MayBeIncludedTwiceByDifferentFiles) {
  folder.write("common.yaml", "a: 1");
  folder.write("left.yaml", "include: common.yaml\nb: 2");
  folder.write("right.yaml", "include: common.yaml\nc: 3");
  folder.write("my.yaml", "include: [left.yaml, right.yaml]");
  EXPECT_EQ(load("my.yaml"), (Map{{"a", 1}, {"b", 2}, {"c", 3}}));
}

TEST_F(IncludedSettings, MayBeNone) {
  folder.write("my.yaml", "include: []\na: 1");
  EXPECT_EQ(load("my.yaml"), (Map{{"a", 1}}));
}

TEST(SettingsFromOutside, MoveTheWritersFoldersWithTheDatasets) {
  Map settings{{"yolo", Map{{"output_folder", "/old/yolo"}, {"main_list", "list.txt"}}}};
  overrideBy({{"simulated_rate", 2.0}}, settings);
  EXPECT_EQ(groupIn(settings, "yolo")->count("output_folder"), 1U);
  overrideBy({{"output_folder", "/new"}}, settings);
  EXPECT_EQ(groupIn(settings, "yolo")->count("output_folder"), 0U);
  EXPECT_EQ(groupIn(settings, "yolo")->count("main_list"), 1U);
}

TEST_F(IncludedSettings, AreNotAFileThatIncludesItself) {
  folder.write("my.yaml", "include: my.yaml");
  EXPECT_EQ(errorOf("my.yaml"), path("my.yaml") + ": include: found a file that includes itself");
  folder.write("a.yaml", "include: b.yaml");
  folder.write("b.yaml", "include: a.yaml");
  EXPECT_EQ(errorOf("a.yaml"), path("a.yaml") + ": include: found a file that includes itself");
  folder.write("below/c.yaml", "include: ../below/c.yaml");
  EXPECT_THAT(errorOf("below/c.yaml"), HasSubstr("include: found a file that includes itself"));
}

TEST_F(IncludedSettings, AreNamedByTexts) {
  const std::string should = "; it should be the name of a settings file, or a list of names";
  folder.write("my.yaml", "include: 3");
  EXPECT_EQ(errorOf("my.yaml"), path("my.yaml") + ": include: found 3" + should);
  folder.write("my.yaml", "include: [a.yaml, 3]");
  EXPECT_EQ(errorOf("my.yaml"), path("my.yaml") + ": include: found [a.yaml, 3]" + should);
  folder.write("my.yaml", "include: {file: a.yaml}");
  EXPECT_THAT(errorOf("my.yaml"), HasSubstr(path("my.yaml") + ": include: found "));
}

TEST_F(IncludedSettings, ThatAreWrongAreNamedByTheirOwnFile) {
  folder.write("my.yaml", "include: nowhere.yaml");
  EXPECT_THAT(errorOf("my.yaml"), HasSubstr(path("nowhere.yaml") + ": no such file"));
  folder.write("broken.yaml", "a: 1\nb: [1");
  folder.write("my.yaml", "include: broken.yaml");
  EXPECT_THAT(errorOf("my.yaml"), HasSubstr(path("broken.yaml") + ": line "));
}

}  // namespace settings_file_test
}  // namespace synthetic_dataset::config

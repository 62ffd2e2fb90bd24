#include "programs/settings/documented_settings.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include <gmock/gmock.h>

#include "base/json_text.h"
#include "base/yaml_value.h"
#include "config/config.h"
#include "support/source_folder.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::programs {
namespace documented_settings_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::vector<std::string> pathsOf(const std::vector<DocumentedSetting>& settings) {
  std::vector<std::string> paths;
  for (const DocumentedSetting& each : settings) paths.push_back(each.path);
  return paths;
}

TEST(DocumentedSettings, AreReadWhetherTheyStandBehindACommentOrNot) {
  const auto settings = documentedSettings(
      "# A heading.\n\n"
      "# REQUIRED. The bag,\n# or a list.\nbag_file: a.bag\n"
      "# placement:\n  # `map` or not.\n  # mode: map\n"
      "camera:\n  # Nearest.\n  near: 0.05  # [m]\n  # effects:\n    # blur: 0.6\nseed: 0\n");
  EXPECT_THAT(pathsOf(settings),
              ElementsAre("bag_file", "placement", "placement/mode", "camera", "camera/near",
                          "camera/effects", "camera/effects/blur", "seed"));
  EXPECT_EQ(settings[0].description, "REQUIRED. The bag, or a list.");
  EXPECT_TRUE(settings[0].isRequired() && settings[0].is_active);
  EXPECT_FALSE(settings[2].is_active);
  EXPECT_EQ(settings[2].value, Value("map"));
  EXPECT_EQ(settings[4].unit, "m");
  EXPECT_EQ(settings[4].value, Value(0.05));
}

TEST(DocumentedSettings, OfAListAreThoseOfItsEntries) {
  EXPECT_THAT(
      pathsOf(documentedSettings("# motions:\n  # - name: hall\n    # Its share.\n    "
                                 "# weight: 1.0\n  # - name: yard\n    # world: y\nseed: 0\n")),
      ElementsAre("motions", "motions/-/name", "motions/-/weight", "motions/-/world", "seed"));
}

TEST(DocumentedSettings, ShareTheCommentAboveThem) {
  const auto settings = documentedSettings("# Of both.\na: 1\nb: 2\n\nc: 3\n");
  EXPECT_EQ(settings[1].description, "Of both.");
  EXPECT_EQ(settings[2].description, "");
}

/// The tree of a settings file with one setting, and what it needs to have an effect.
Value with(const DocumentedSetting& setting, const std::string& mode) {
  const Value value = setting.text.empty() ? Value(Value::Map{}) : setting.value;
  std::vector<std::string> parts;
  std::istringstream stream(setting.path);
  for (std::string part; std::getline(stream, part, '/');) parts.push_back(part);
  Value tree = value;
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    Value::Map group = {{*part, tree}};
    if (*part == "placement" && tree.is<Value::Map>()) {
      group["motion"] = Value("placement");
      group.at("placement").as<Value::Map>()->emplace("mode", Value(mode));
    }
    // These have a meaning only beside pictures.
    if (*part == "background" && tree.is<Value::Map>()) {
      group.at(*part).as<Value::Map>()->emplace("pictures", Value("pictures"));
    }
    if (*part == "depth_noise" && tree.is<Value::Map>()) {
      group.at(*part).as<Value::Map>()->emplace(
          "model", Value(mode == "map" ? "stereo" : "structured_light"));
    }
    if (*part == "distractors") group.at(*part).as<Value::Map>()->emplace("mode", Value("drop"));
    tree = Value(group);
  }
  auto& root = *tree.as<Value::Map>();
  if (parts.front() == "scenes") root["motion"] = Value("placement");
  if (parts.front() != "robot_list") root.emplace("robot_list", Value(Value::List{Value("alpha")}));
  return tree;
}

/// Whether a setting is read in at least one of the ways in which scenes are placed and depth is
/// measured.
bool isRead(const DocumentedSetting& setting) {
  for (const std::string mode : {"map", "volume", "drop"}) {
    Parameters root(with(setting, mode));
    (void)config::readConfig(root);
    const std::vector<std::string> unknown = root.unknownNames();
    if (std::find(unknown.begin(), unknown.end(), setting.path) == unknown.end()) return true;
  }
  return false;
}

/// Whether a setting is not read by the configuration but by the file's reader, the list of motions
/// or writers.
bool isOfOthers(const std::string& path) {
  static const std::set<std::string> kGroups = {"include", "motions", "cameras",
                                                "yolo",    "stvnet",  "bounding_shape"};
  return kGroups.count(path.substr(0, path.find('/'))) != 0;
}

TEST(SettingsDocument, ListsNoSettingThatNobodyReads) {
  std::vector<std::string> unread;
  for (const DocumentedSetting& each : documentedSettings()) {
    if (!isOfOthers(each.path) && !each.text.empty() && !isRead(each)) unread.push_back(each.path);
  }
  EXPECT_THAT(unread, IsEmpty());
}

TEST(SettingsDocument, ListsEverySettingThatIsReadInAGroupOfIts) {
  const auto& settings = documentedSettings();
  const std::vector<std::string> listed = pathsOf(settings);
  std::set<std::string> missing;
  for (const DocumentedSetting& each : settings) {
    if (isOfOthers(each.path) || each.text.empty()) continue;
    for (const std::string mode : {"map", "volume", "drop"}) {
      Parameters root(with(each, mode));
      (void)config::readConfig(root);
      const std::size_t slash = each.path.rfind('/');
      const std::string group = slash == std::string::npos ? "" : each.path.substr(0, slash + 1);
      for (const std::string& name : root.knownNeighbours(each.path)) missing.insert(group + name);
    }
  }
  for (const std::string& each : listed) missing.erase(each);
  missing.erase("stvnet");                  // a writer's, whose settings are in docs/formats.md
  missing.erase("placement/received_map");  // which the program sets itself
  EXPECT_THAT(missing, IsEmpty());
}

TEST(SettingsDocument, HasTheDefaultsThatTheReadersHave) {
  const auto declared = declaredSettings();
  int count = 0;
  for (const DocumentedSetting& each : documentedSettings()) {
    const auto found = declared.find(each.path);
    const bool is_recommended = each.description.find("(default ") != std::string::npos;
    if (!each.is_active || is_recommended || each.isRequired() || found == declared.end()) continue;
    const auto fallback = found->second.find("default");
    if (fallback == found->second.end()) continue;
    Parameters both(Value::Map{{"documented", each.value}, {"read", fallback->second}});
    if (fallback->second.is<double>()) {
      EXPECT_EQ(both.required<double>("documented"), both.required<double>("read")) << each.path;
    } else if (!each.value.is<Value::List>()) {  // lists are examples beside a default word
      EXPECT_EQ(each.value, fallback->second) << each.path;
    }
    ++count;
  }
  EXPECT_GT(count, 15);
}

TEST(DeclaredSettings, HaveRangesAndChoices) {
  const auto declared = declaredSettings();
  EXPECT_EQ(declared.at("camera/effects/blur").at("range"), Value(Value::List{0.0, 50.0}));
  EXPECT_EQ(declared.at("randomize/weather/dust").at("range"), Value(Value::List{0.0, 0.2}));
  EXPECT_EQ(declared.at("placement/mode").at("choices"),
            Value(Value::List{"map", "ground", "volume", "drop"}));
  EXPECT_EQ(declared.at("placement/mode").at("default"), Value("map"));
  EXPECT_EQ(declared.at("rendering/shadow_map_size").at("default"), Value(2048));
}

TEST(SettingsSchema, TellsEditorsWhatThereIs) {
  const Value schema = settingsSchema();
  const Value read = base::parseYaml(base::jsonText(schema), "schema");
  const auto property = [](const Value& node, const std::string& name) {
    return node.as<Value::Map>()->at("properties").as<Value::Map>()->at(name);
  };
  const Value near = property(property(read, "camera"), "near");
  EXPECT_EQ(near.as<Value::Map>()->at("default"), Value(0.05));
  EXPECT_EQ(property(read, "camera").as<Value::Map>()->at("additionalProperties"), Value(false));
  EXPECT_THAT(*property(read, "bag_file").as<Value::Map>()->at("description").as<std::string>(),
              HasSubstr("REQUIRED"));
  EXPECT_EQ(property(read, "bag_file").as<Value::Map>()->count("default"), 0U);
  const Value entry = property(read, "motions").as<Value::Map>()->at("items");
  EXPECT_EQ(entry.as<Value::Map>()->at("properties").as<Value::Map>()->count("weight"), 1U);
}

/// The errors that an editor with the schema underlines.
void findUnknown(const Value& schema, const Value& value, const std::string& path,
                 std::vector<std::string>& unknown) {
  const auto& rules = *schema.as<Value::Map>();
  const auto rule = [&](const std::string& name) {
    const auto found = rules.find(name);
    return found == rules.end() ? nullptr : &found->second;
  };
  for (const auto& [name, content] : rules) {
    static const std::set<std::string> kKnown = {
        "$schema", "title",    "type",       "description",         "default",
        "items",   "examples", "properties", "additionalProperties"};
    EXPECT_EQ(kKnown.count(name), 1U) << "this test does not know what '" << name << "' means";
  }
  if (const auto* list = value.as<Value::List>(); list != nullptr && rule("items") != nullptr) {
    for (const Value& each : *list) findUnknown(*rule("items"), each, path + "[]", unknown);
  }
  const auto* map = value.as<Value::Map>();
  if (map == nullptr || rule("properties") == nullptr) return;
  const auto& properties = *rule("properties")->as<Value::Map>();
  for (const auto& [name, content] : *map) {
    const auto property = properties.find(name);
    if (property != properties.end()) {
      findUnknown(property->second, content, path + "/" + name, unknown);
    } else if (rule("additionalProperties") != nullptr) {
      EXPECT_EQ(*rule("additionalProperties"), Value(false));
      unknown.push_back(path + "/" + name);
    }
  }
}

std::vector<std::string> unknownIn(const std::string& settings) {
  const Value schema = settingsSchema();
  std::vector<std::string> unknown;
  findUnknown(schema, base::parseSettings(settings, "settings"), "", unknown);
  return unknown;
}

TEST(SettingsSchema, TakesAllSettingsThatAreShipped) {
  int count = 0;
  for (const auto& each : std::filesystem::directory_iterator(test::sourceFolder() + "/config")) {
    if (each.path().extension() != ".yaml") continue;
    ++count;
    EXPECT_THAT(unknownIn(test::readFile(each.path())), IsEmpty()) << each.path();
  }
  EXPECT_GE(count, 5);
}

TEST(SettingsSchema, UnderlinesWhatIsMisspelt) {
  EXPECT_THAT(unknownIn("camera: {naer: 0.1}\nrover_1: {class: rover}\nworld: {fiel: a}\n"),
              ElementsAre("/camera/naer", "/world/fiel"));
}

}  // namespace documented_settings_test
}  // namespace synthetic_dataset::programs

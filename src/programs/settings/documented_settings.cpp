#include "programs/settings/documented_settings.h"

#include <algorithm>
#include <optional>
#include <regex>
#include <sstream>
#include <utility>

#include "base/json_text.h"
#include "base/yaml_value.h"
#include "config/config.h"
#include "config/settings_text.h"
#include "programs/embedded/embedded_files.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace {

/// A line of the file that is a setting.
struct SettingLine {
  std::size_t indentation = 0;
  bool is_active = false;
  bool begins_entry = false;  ///< of a list: "- name: hall"
  std::string name;
  std::string value;
  std::string unit;
};

std::optional<SettingLine> settingIn(const std::string& line) {
  static const std::regex kSetting(
      R"re(( *)(# )?(- )?([a-z_][a-z_0-9]*):(?: +(.*?))?(?:  # \[(.*)\])?)re");
  std::smatch match;
  if (!std::regex_match(line, match, kSetting)) return std::nullopt;
  SettingLine setting;
  setting.begins_entry = match[3].matched;
  setting.indentation = match[1].str().size() + (setting.begins_entry ? 2U : 0U);
  setting.is_active = !match[2].matched;
  setting.name = match[4].str();
  setting.value = match[5].str();
  setting.unit = match[6].str();
  return setting;
}

/// The text of a comment's line, if it is one.
std::optional<std::string> commentIn(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(' ');
  if (begin == std::string::npos || line[begin] != '#') return std::nullopt;
  return line.substr(std::min(begin + 2, line.size()));
}

/// Parses a value; one that is not YAML, because the user has to complete it, stays a text.
Value valueOf(const std::string& text, const std::string& path) {
  if (text.empty()) return {};
  try {
    return base::parseSettings(text, path);
  } catch (const Error&) {
    return text;
  }
}

bool isComplete(const std::string& value) {
  return std::count(value.begin(), value.end(), '[') == std::count(value.begin(), value.end(), ']');
}

class DocumentReader {
 public:
  std::vector<DocumentedSetting> read(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) take(line);
    for (DocumentedSetting& each : settings_) each.value = valueOf(each.text, each.path);
    return std::move(settings_);
  }

 private:
  void take(const std::string& line) {
    if (!settings_.empty() && !isComplete(settings_.back().text)) {
      settings_.back().text +=
          " " + line.substr(std::min(line.find_first_not_of(' '), line.size()));
      return;
    }
    if (const auto setting = settingIn(line)) {
      add(*setting);
      return;
    }
    if (const auto comment = commentIn(line)) {
      const bool is_heading = comment->rfind("---", 0) == 0;
      if (!is_heading) comment_ += (comment_.empty() ? "" : " ") + *comment;
    } else {
      comment_.clear();  // an empty line: a comment above it is about more than one setting
      block_.reset();
    }
  }

  void add(const SettingLine& line) {
    while (!above_.empty() && above_.back().first >= line.indentation) above_.pop_back();
    std::string path;
    for (const auto& [indentation, name] : above_) path += name + "/";
    if (line.begins_entry) indented_list_ = path;
    if (indented_list_ && path == *indented_list_ && line.indentation > 0) path += "-/";
    const std::string full = path + line.name;
    const bool is_known =
        std::any_of(settings_.begin(), settings_.end(),
                    [&](const DocumentedSetting& each) { return each.path == full; });
    if (!is_known) {
      settings_.push_back({full, descriptionOf(path), line.unit, line.value, {}, line.is_active});
    }
    comment_.clear();
    block_ = is_known ? std::nullopt : std::optional(path);
    if (line.value.empty()) above_.emplace_back(line.indentation, line.name);
  }

  /// A comment describes all settings that follow it, up to the next comment.
  [[nodiscard]] std::string descriptionOf(const std::string& path) const {
    const bool goes_on = comment_.empty() && block_ == path && !settings_.empty();
    return goes_on ? settings_.back().description : comment_;
  }

  std::vector<DocumentedSetting> settings_;
  std::string comment_;
  std::optional<std::string> block_;  ///< the previous setting's group; none after an empty line
  std::vector<std::pair<std::size_t, std::string>> above_;  ///< groups with their indentations
  std::optional<std::string> indented_list_;                ///< the path of the list last seen
};

/// The schema of a path's last part; makes those on the way to it that are missing.
Value::Map& nodeOf(Value::Map& root, const std::string& path) {
  Value::Map* node = &root;
  std::istringstream parts(path);
  for (std::string part; std::getline(parts, part, '/');) {
    if (part == "-") {
      Value& items = (*node)["items"];
      if (items.isNull()) items = Value::Map{};
      node = items.as<Value::Map>();
      continue;
    }
    Value& properties = (*node)["properties"];
    if (properties.isNull()) properties = Value::Map{};
    Value& child = (*properties.as<Value::Map>())[part];
    if (child.isNull()) child = Value::Map{};
    node = child.as<Value::Map>();
  }
  return *node;
}

/// Closes the groups whose names are all known, in which any other name is a misspelling.
void closeGroups(Value::Map& root) {
  for (const char* path :
       {"placement", "world", "camera", "camera/sample", "camera/effects", "camera/depth_noise",
        "labels", "masks", "background_subtractor", "physics", "rendering", "image", "randomize",
        "randomize/sensor", "randomize/background", "randomize/weather"}) {
    nodeOf(root, path)["additionalProperties"] = Value(false);
  }
}

}  // namespace

std::vector<DocumentedSetting> documentedSettings(const std::string& text) {
  return DocumentReader().read(text);
}

const std::vector<DocumentedSetting>& documentedSettings() {
  static const auto kSettings = documentedSettings(settingsDocument());
  return kSettings;
}

const std::string& settingsDocument() {
  static const std::string kText = EmbeddedFiles().find("params.yaml").value();
  return kText;
}

std::map<std::string, Value::Map> declaredSettings() {
  std::map<std::string, std::string> flat;
  for (const DocumentedSetting& each : documentedSettings()) {
    if (!each.value.isNull() && each.path.find('-') == std::string::npos) {
      flat[each.path] = base::jsonText(each.value);
    }
  }
  std::map<std::string, Value::Map> declared;
  for (const std::string mode : {"", "map", "volume", "drop"}) {
    flat["motion"] = mode.empty() ? "bag" : "placement";
    flat["placement/mode"] = mode;
    flat["camera/depth_noise/model"] = mode.empty() ? "structured_light" : "stereo";
    flat["randomize/distractors/mode"] = "drop";
    Parameters root(config::settingsTree(flat));
    (void)config::readConfig(root);
    declared.insert(root.declarations().begin(), root.declarations().end());
    for (const char* other : {"camera/sample/position", "randomize/distractors/models"}) {
      flat.erase(other);  // while it is set, some settings have no meaning
    }
  }
  return declared;
}

Value settingsSchema() {
  Value::Map root = {{"$schema", Value("http://json-schema.org/draft-07/schema#")},
                     {"title", Value("Settings of synthetic_dataset")},
                     {"type", Value("object")}};
  for (const DocumentedSetting& setting : documentedSettings()) {
    Value::Map& node = nodeOf(root, setting.path);
    if (!setting.description.empty()) node["description"] = Value(setting.description);
    if (setting.value.isNull()) continue;
    if (setting.is_active && !setting.isRequired()) {
      node["default"] = setting.value;
    } else {
      node["examples"] = Value(Value::List{setting.value});
    }
  }
  closeGroups(root);
  return Value(root);
}

}  // namespace synthetic_dataset::programs

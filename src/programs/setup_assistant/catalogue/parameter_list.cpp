#include "programs/setup_assistant/catalogue/parameter_list.h"

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

#include "base/yaml_value.h"
#include "programs/settings/documented_settings.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace {

/// "... [m/s] ..." : the first unit that is one.
std::string unitIn(const std::string& text) {
  static const std::regex kUnit(R"(\[(m|s|rad|px|Hz|byte|kg|m/s|rad/s|mm|deg|lx|cd|s\^-1)\])");
  std::smatch match;
  return std::regex_search(text, match, kUnit) ? match[1].str() : "";
}

/// "`map`: on free cells; `volume`: anywhere": each word in backquotes that a colon follows, or the
/// parts of "`a`, `b` or `c`".
std::vector<std::string> choicesIn(const std::string& text, const std::string& value) {
  static const std::regex kWord("`([a-z][a-z_0-9]*)`");
  std::vector<std::string> words;
  for (std::sregex_iterator word(text.begin(), text.end(), kWord), end; word != end; ++word) {
    const std::string found = (*word)[1];
    if (std::find(words.begin(), words.end(), found) == words.end()) words.push_back(found);
  }
  const bool has_value = std::find(words.begin(), words.end(), value) != words.end();
  return has_value && words.size() > 1 ? words : std::vector<std::string>();
}

Value parameterValue(const DocumentedSetting& setting) {
  Value value;
  try {
    value = base::parseYaml(setting.value, setting.path);
  } catch (const Error&) {  // what a user has to complete
    value = setting.value;
  }
  Value::Map parameter = {{"path", Value(setting.path)},
                          {"default", value},
                          {"example", Value(!setting.is_active || setting.isRequired())},
                          {"text", Value(setting.description)},
                          {"required", Value(setting.isRequired())}};
  const std::string unit = unitIn(setting.description);
  if (!unit.empty()) parameter["unit"] = unit;
  Value::List choices;
  for (const std::string& each : choicesIn(setting.description, setting.value)) {
    choices.emplace_back(each);
  }
  if (value.is<bool>()) choices = {Value(true), Value(false)};
  if (!choices.empty()) parameter["choices"] = choices;
  return parameter;
}

}  // namespace

Value parameterList() {
  Value::List parameters;
  for (const DocumentedSetting& each : documentedSettings(settingsDocument())) {
    parameters.push_back(parameterValue(each));
  }
  return Value::Map{{"parameters", Value(parameters)}};
}

}  // namespace synthetic_dataset::programs

#include "base/yaml_text/yaml_rendering.h"

#include <algorithm>
#include <set>

#include "base/json_text.h"
#include "base/yaml_scalar.h"

namespace synthetic_dataset::base {
namespace {

constexpr std::size_t kWidestLine = 100;

bool isControl(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

bool hasControls(const std::string& text) {
  return std::any_of(text.begin(), text.end(), isControl);
}

/// Whether YAML reads a text as itself if it has no quotes.
bool isPlain(const std::string& text, bool in_flow) {
  static const std::set<std::string> kNothing = {"", "~", "null", "Null", "NULL", "<<"};
  if (kNothing.count(text) != 0 || hasControls(text)) return false;
  if (isAngleText(text)) return true;
  if (!plainScalar(text).is<std::string>() || isTimestamp(text)) return false;
  if (decimalNumber(text)) return false;  // 1e5 is a text for PyYAML, and a number for people
  if (std::string("-?:,[]{}#&*!|>'\"%@`= ").find(text.front()) != std::string::npos) return false;
  if (text.back() == ' ' || text.back() == ':') return false;
  // The result of a substitution may need quotes.
  if (text.find("$(") != std::string::npos) return false;
  if (text.find(": ") != std::string::npos || text.find(" #") != std::string::npos) return false;
  if (text.rfind("...", 0) == 0) return false;
  return !in_flow || text.find_first_of(",[]{}:") == std::string::npos;
}

std::string singleQuoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

std::string textYaml(const std::string& text, bool in_flow) {
  return isPlain(text, in_flow) ? text : jsonText(Value(text));
}

bool isCollection(const Value& value) { return value.is<Value::List>() || value.is<Value::Map>(); }

bool isEmpty(const Value& value) {
  const auto* list = value.as<Value::List>();
  const auto* map = value.as<Value::Map>();
  return (list != nullptr && list->empty()) || (map != nullptr && map->empty());
}

bool holdsCollections(const Value& value) {
  const auto full = [](const Value& each) { return isCollection(each) && !isEmpty(each); };
  if (const auto* list = value.as<Value::List>()) {
    return std::any_of(list->begin(), list->end(), full);
  }
  const auto* map = value.as<Value::Map>();
  return map != nullptr &&
         std::any_of(map->begin(), map->end(), [&](const auto& each) { return full(each.second); });
}

}  // namespace

bool isAngleText(const std::string& text) {
  const bool begins = text.rfind("deg(", 0) == 0 || text.rfind("rad(", 0) == 0;
  return begins && text.find(')') == text.size() - 1 && !hasControls(text);
}

std::string flowYaml(const Value& value, bool in_flow) {
  std::string result;
  if (const auto* text = value.as<std::string>()) return textYaml(*text, in_flow);
  if (const auto* list = value.as<Value::List>()) {
    for (const Value& each : *list) result += (result.empty() ? "" : ", ") + flowYaml(each, true);
    return "[" + result + "]";
  }
  if (const auto* map = value.as<Value::Map>()) {
    for (const auto& [name, each] : *map) {
      result += (result.empty() ? "" : ", ") + nameYaml(name, true) + ": " + flowYaml(each, true);
    }
    return "{" + result + "}";
  }
  return jsonText(value);
}

std::string scalarLike(const Value& value, const std::string& earlier, bool in_flow) {
  const auto* text = value.as<std::string>();
  if (text != nullptr && !earlier.empty() && !isAngleText(*text)) {
    if (earlier.front() == '\'' && !hasControls(*text)) return singleQuoted(*text);
    if (earlier.front() == '"') return jsonText(value);
  }
  // Programs without integers write 3 for 3.0.
  const auto* whole = value.as<std::int64_t>();
  if (whole != nullptr && plainScalar(earlier).is<double>()) {
    return jsonText(Value(static_cast<double>(*whole)));
  }
  return flowYaml(value, in_flow);
}

std::string nameYaml(const std::string& name, bool in_flow) {
  return isAngleText(name) ? jsonText(Value(name)) : textYaml(name, in_flow);
}

bool wantsLines(const Value& value, std::size_t column) {
  if (!isCollection(value) || isEmpty(value)) return false;
  return value.is<Value::Map>() || holdsCollections(value) ||
         column + flowYaml(value, false).size() > kWidestLine;
}

std::string blockYaml(const Value& value, std::size_t column, const YamlLayout& layout) {
  const std::string between = layout.line_break + std::string(column, ' ');
  std::string result;
  if (const auto* list = value.as<Value::List>()) {
    for (const Value& each : *list) {
      result += (result.empty() ? "" : between) + dashYaml(each, column, layout);
    }
  } else if (const auto* map = value.as<Value::Map>()) {
    for (const auto& [name, each] : *map) {
      result += (result.empty() ? "" : between) + entryYaml(name, each, column, layout);
    }
  }
  return result;
}

std::string entryYaml(const std::string& name, const Value& value, std::size_t column,
                      const YamlLayout& layout) {
  const std::string start = nameYaml(name, false) + ":";
  if (!wantsLines(value, column + start.size() + 1)) return start + " " + flowYaml(value, false);
  const std::size_t below =
      column + (value.is<Value::List>() ? layout.list_indentation : layout.indentation);
  return start + layout.line_break + std::string(below, ' ') + blockYaml(value, below, layout);
}

std::string dashYaml(const Value& value, std::size_t column, const YamlLayout& layout) {
  constexpr std::size_t kDash = 2;
  const bool fits = column + kDash + flowYaml(value, false).size() <= kWidestLine;
  const bool is_long = isCollection(value) && !isEmpty(value) && (holdsCollections(value) || !fits);
  return "- " + (is_long ? blockYaml(value, column + kDash, layout) : flowYaml(value, false));
}

}  // namespace synthetic_dataset::base

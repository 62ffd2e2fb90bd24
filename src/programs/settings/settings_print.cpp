#include "programs/settings/settings_print.h"

#include <cstddef>

#include "base/json_text.h"

namespace synthetic_dataset::programs {
namespace {

constexpr std::size_t kLineLength = 100;

void print(const Value& value, std::size_t indent, std::string& text);

/// Prints a value after the "name:" or "-" to which it belongs, on the same line if it fits.
void printBehind(const Value& value, std::size_t indent, std::string& text) {
  const std::string flow = base::jsonText(value);
  const bool has_parts = (value.is<Value::Map>() && !value.as<Value::Map>()->empty()) ||
                         (value.is<Value::List>() && !value.as<Value::List>()->empty());
  if (!has_parts || indent + flow.size() <= kLineLength) {
    text += " " + flow + "\n";
    return;
  }
  text += "\n";
  print(value, indent + 2, text);
}

/// @param value  a map or a list that is not empty
void print(const Value& value, std::size_t indent, std::string& text) {
  const std::string begin(indent, ' ');
  if (const auto* map = value.as<Value::Map>()) {
    for (const auto& [name, entry] : *map) {
      text += begin + base::jsonText(Value(name)) + ":";
      printBehind(entry, indent, text);
    }
  } else if (const auto* list = value.as<Value::List>()) {
    for (const Value& entry : *list) {
      text += begin + "-";
      printBehind(entry, indent, text);
    }
  }
}

}  // namespace

std::string settingsYaml(const Value& settings) {
  std::string text;
  print(settings, 0, text);
  return text;
}

}  // namespace synthetic_dataset::programs

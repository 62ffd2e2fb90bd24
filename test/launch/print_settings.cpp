/// Prints how settings files are read, a line of JSON for each, for settings_test.py.
///
///   print_settings FILE...
///
/// {"error": "..."} where a file is refused. A number with a fraction is {"float": "0x1.8p+1"}.

#include <cstdio>
#include <iostream>
#include <string>

#include "base/json_text.h"
#include "config/settings_file.h"
#include "run/setup/package_index.h"
#include "synthetic_dataset/errors.h"

namespace {

using namespace synthetic_dataset;

std::string formatted(const char* format, double number) {
  char text[40];
  std::snprintf(text, sizeof text, format, number);
  return text;
}

std::string json(const Value& value) {
  if (const auto* flag = value.as<bool>()) return *flag ? "true" : "false";
  if (const auto* number = value.as<std::int64_t>()) return std::to_string(*number);
  if (const auto* number = value.as<double>()) {
    return "{\"float\": \"" + formatted("%a", *number) + "\"}";
  }
  if (value.is<std::string>()) return base::jsonText(value);
  std::string entries;
  if (const auto* list = value.as<Value::List>()) {
    for (const Value& entry : *list) entries += (entries.empty() ? "" : ", ") + json(entry);
    return "[" + entries + "]";
  }
  if (const auto* map = value.as<Value::Map>()) {
    for (const auto& [name, entry] : *map) {
      entries += (entries.empty() ? "" : ", ") + base::jsonText(name) + ": " + json(entry);
    }
    return "{" + entries + "}";
  }
  return "null";
}

}  // namespace

int main(int argc, char** argv) {
  const auto packages = run::rosPackageFinder();
  for (int i = 1; i < argc; ++i) {
    try {
      std::cout << json(Value(config::loadSettings(argv[i], packages))) << '\n';
    } catch (const Error& error) {
      std::cout << "{\"error\": " << base::jsonText(error.what()) << "}\n";
    }
  }
}

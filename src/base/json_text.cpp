#include "base/json_text.h"

#include <cmath>
#include <cstdio>

namespace synthetic_dataset::base {
namespace {

/// RFC 8259, section 7.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += std::string("\\") + c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      char code[8];
      std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(c));
      result += code;
    } else {
      result += c;
    }
  }
  return result + "\"";
}

/// With a point, without which YAML 1.1 takes 1e-05 for a text.
std::string numberText(double number) {
  if (std::isnan(number)) return ".nan";
  if (std::isinf(number)) return number < 0.0 ? "-.inf" : ".inf";
  std::string text = Value(number).text();
  const std::size_t exponent = text.find('e');
  if (exponent != std::string::npos && text.find('.') == std::string::npos) {
    text.insert(exponent, ".0");
  }
  return text;
}

}  // namespace

std::string jsonText(const Value& value) {
  if (value.isNull()) return "null";
  if (const auto* flag = value.as<bool>()) return *flag ? "true" : "false";
  if (const auto* number = value.as<double>()) return numberText(*number);
  if (const auto* text = value.as<std::string>()) return quoted(*text);
  std::string result;
  if (const auto* list = value.as<Value::List>()) {
    for (const Value& entry : *list) result += (result.empty() ? "" : ", ") + jsonText(entry);
    return "[" + result + "]";
  }
  if (const auto* map = value.as<Value::Map>()) {
    for (const auto& [name, entry] : *map) {
      result += (result.empty() ? "" : ", ") + quoted(name) + ": " + jsonText(entry);
    }
    return "{" + result + "}";
  }
  return value.text();
}

}  // namespace synthetic_dataset::base

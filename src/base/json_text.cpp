#include "base/json_text.h"

#include <cmath>
#include <cstdio>
#include <limits>

#include <nlohmann/json.hpp>

#include "base/nesting.h"
#include "base/printable_text.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace {

/// A JSON string (RFC 8259, section 7).
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

/// A number with a decimal point, without which YAML 1.1 reads 1e-05 as a text.
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

enum class Dialect { kYaml, kStrict };

std::string textOf(const Value& value, Dialect dialect) {
  if (value.isNull()) return "null";
  if (const auto* flag = value.as<bool>()) return *flag ? "true" : "false";
  if (const auto* number = value.as<double>()) {
    const std::string text = numberText(*number);
    return dialect == Dialect::kStrict && !std::isfinite(*number) ? quoted(text) : text;
  }
  if (const auto* text = value.as<std::string>()) {
    return quoted(dialect == Dialect::kStrict ? asUtf8(*text) : *text);
  }
  std::string result;
  if (const auto* list = value.as<Value::List>()) {
    for (const Value& entry : *list) {
      result += (result.empty() ? "" : ", ") + textOf(entry, dialect);
    }
    return "[" + result + "]";
  }
  if (const auto* map = value.as<Value::Map>()) {
    for (const auto& [name, entry] : *map) {
      result += (result.empty() ? "" : ", ") +
                quoted(dialect == Dialect::kStrict ? asUtf8(name) : name) + ": " +
                textOf(entry, dialect);
    }
    return "{" + result + "}";
  }
  return value.text();
}

Value textOrNumber(const std::string& text) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (text == ".inf") return kInfinity;
  if (text == "-.inf") return -kInfinity;
  if (text == ".nan") return std::numeric_limits<double>::quiet_NaN();
  return text;
}

Value valueOf(const nlohmann::json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_string()) return textOrNumber(json.get<std::string>());
  if (json.is_number_unsigned() &&
      json.get<std::uint64_t>() >
          static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
    return json.get<double>();
  }
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_number()) return json.get<double>();
  if (json.is_array()) {
    Value::List list;
    for (const auto& entry : json) list.push_back(valueOf(entry));
    return list;
  }
  if (!json.is_object()) return {};
  Value::Map map;
  for (const auto& [name, entry] : json.items()) map[name] = valueOf(entry);
  return map;
}

}  // namespace

std::string jsonText(const Value& value) { return textOf(value, Dialect::kYaml); }

std::string strictJsonText(const Value& value) { return textOf(value, Dialect::kStrict); }

Value parseJson(const std::string& text, const std::string& origin) {
  if (isDeepJson(text)) throw Error(origin + ": " + kNestedTooDeep);
  try {
    return valueOf(nlohmann::json::parse(text));
  } catch (const nlohmann::json::exception& error) {
    throw Error(origin + ": cannot be read as JSON: " + error.what());
  }
}

}  // namespace synthetic_dataset::base

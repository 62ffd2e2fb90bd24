#include "config/yaml_value.h"

#include <fstream>
#include <iterator>
#include <limits>
#include <locale>
#include <optional>
#include <regex>
#include <sstream>
#include <stdexcept>

#include <yaml-cpp/yaml.h>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::config {
namespace {

constexpr int kDeepestNesting = 64;

[[noreturn]] void fail(const std::string& origin, const YAML::Mark& mark,
                       const std::string& message) {
  std::string place = origin;
  if (mark.line >= 0) place += ": line " + std::to_string(mark.line + 1);
  throw Error(place + ": " + message);
}

std::string withoutUnderscores(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c != '_') result += c;
  }
  return result;
}

std::optional<Value> asBool(const std::string& text) {
  static const std::regex kTrue("yes|Yes|YES|true|True|TRUE|on|On|ON");
  static const std::regex kFalse("no|No|NO|false|False|FALSE|off|Off|OFF");
  if (std::regex_match(text, kTrue)) return Value(true);
  if (std::regex_match(text, kFalse)) return Value(false);
  return std::nullopt;
}

/// YAML 1.1's integers (https://yaml.org/type/int.html), without base 60: nobody means 1:30 as 90.
std::optional<Value> asInteger(const std::string& text) {
  static const std::regex kInteger("[-+]?(0b[01_]+|0x[0-9a-fA-F_]+|0[0-7_]*|[1-9][0-9_]*)");
  if (!std::regex_match(text, kInteger)) return std::nullopt;
  std::string digits = withoutUnderscores(text);
  const bool negative = digits[0] == '-';
  if (digits[0] == '-' || digits[0] == '+') digits.erase(0, 1);
  int base = 10;
  if (digits.rfind("0b", 0) == 0) {
    base = 2;
    digits.erase(0, 2);
  } else if (digits.rfind("0x", 0) == 0) {
    base = 16;
    digits.erase(0, 2);
  } else if (digits.size() > 1 && digits[0] == '0') {
    base = 8;
  }
  try {
    const std::int64_t number = std::stoll(digits, nullptr, base);
    return Value(negative ? -number : number);
  } catch (const std::out_of_range&) {
    return std::nullopt;
  }
}

/// YAML 1.1's floats as PyYAML reads them: a point is needed, 1e5 is a text.
std::optional<Value> asFloat(const std::string& text) {
  static const std::regex kFloat("[-+]?([0-9][0-9_]*\\.[0-9_]*|\\.[0-9][0-9_]*)([eE][-+][0-9]+)?");
  static const std::regex kInfinite("[-+]?\\.(inf|Inf|INF)");
  static const std::regex kNan("\\.(nan|NaN|NAN)");
  if (std::regex_match(text, kNan)) return Value(std::numeric_limits<double>::quiet_NaN());
  if (std::regex_match(text, kInfinite)) {
    const double infinity = std::numeric_limits<double>::infinity();
    return Value(text[0] == '-' ? -infinity : infinity);
  }
  if (!std::regex_match(text, kFloat)) return std::nullopt;
  std::istringstream stream(withoutUnderscores(text));
  stream.imbue(std::locale::classic());
  double number = 0.0;
  stream >> number;
  if (stream.fail()) return std::nullopt;
  return Value(number);
}

Value scalar(const YAML::Node& node) {
  const std::string& text = node.Scalar();
  const bool quoted = node.Tag() == "!";
  if (quoted || node.Tag() == "tag:yaml.org,2002:str") return Value(text);
  if (auto value = asBool(text)) return *value;
  if (auto value = asInteger(text)) return *value;
  if (auto value = asFloat(text)) return *value;
  return Value(text);
}

Value convert(const YAML::Node& node, const std::string& origin, int depth) {
  if (depth > kDeepestNesting) {
    fail(
        origin, node.Mark(),
        "nested deeper than " + std::to_string(kDeepestNesting) + " levels (does it hold itself?)");
  }
  switch (node.Type()) {
    case YAML::NodeType::Scalar:
      return scalar(node);
    case YAML::NodeType::Sequence: {
      Value::List list;
      for (const YAML::Node& entry : node) list.push_back(convert(entry, origin, depth + 1));
      return list;
    }
    case YAML::NodeType::Map: {
      Value::Map map;
      for (const auto& entry : node) {
        if (!entry.first.IsScalar()) fail(origin, entry.first.Mark(), "a name should be a text");
        map[entry.first.Scalar()] = convert(entry.second, origin, depth + 1);
      }
      return map;
    }
    default:
      return {};
  }
}

}  // namespace

Value parseYaml(const std::string& text, const std::string& origin) {
  try {
    return convert(YAML::Load(text), origin, 0);
  } catch (const YAML::Exception& error) {
    fail(origin, error.mark, error.msg);
  }
}

Value loadYamlFile(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error(file + ": no such file, or it cannot be read");
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  return parseYaml(text, file);
}

}  // namespace synthetic_dataset::config

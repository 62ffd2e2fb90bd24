#include "base/yaml_scalar.h"

#include <algorithm>
#include <limits>
#include <locale>
#include <regex>
#include <sstream>

namespace synthetic_dataset::base {
namespace {

/// std::regex recurses for each character, and no useful number is longer.
constexpr std::size_t kLongestNumber = 400;

bool matches(const std::string& text, const std::regex& pattern) {
  return text.size() <= kLongestNumber && std::regex_match(text, pattern);
}

std::string withoutUnderscores(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), '_'), text.end());
  return text;
}

bool takeMinus(std::string& text) {
  const bool negative = text[0] == '-';
  if (negative || text[0] == '+') text.erase(0, 1);
  return negative;
}

/// 1:30 is 1 * 60 + 30. nullopt if it does not fit into std::int64_t.
std::optional<std::int64_t> fromBase60(const std::string& text) {
  std::istringstream stream(text);
  std::int64_t number = 0;
  for (std::string part; std::getline(stream, part, ':');) {
    const auto digits = decimalNumber(part);
    constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max() / 60 - 60;
    if (!digits || *digits > 1e15 || number > kLargest) return std::nullopt;
    number = number * 60 + static_cast<std::int64_t>(*digits);
  }
  return number;
}

double fromBase60WithFraction(const std::string& text) {
  std::istringstream stream(text);
  double number = 0.0;
  for (std::string part; std::getline(stream, part, ':');) {
    number = number * 60.0 + decimalNumber(part).value_or(0.0);
  }
  return number;
}

}  // namespace

std::optional<bool> asBool(const std::string& text) {
  static const std::regex kTrue("yes|Yes|YES|true|True|TRUE|on|On|ON");
  static const std::regex kFalse("no|No|NO|false|False|FALSE|off|Off|OFF");
  if (matches(text, kTrue)) return true;
  if (matches(text, kFalse)) return false;
  return std::nullopt;
}

std::optional<std::int64_t> asInteger(const std::string& text) {
  static const std::regex kInteger(
      "[-+]?(0b[01_]+|0x[0-9a-fA-F_]+|0[0-7_]+|0|[1-9][0-9_]*(:[0-5]?[0-9])*)");
  if (!matches(text, kInteger)) return std::nullopt;
  std::string digits = withoutUnderscores(text);
  const bool negative = takeMinus(digits);
  if (digits.find(':') != std::string::npos) {
    const auto number = fromBase60(digits);
    return number && negative ? -*number : number;
  }
  int base = 10;
  if (digits.rfind("0b", 0) == 0 || digits.rfind("0x", 0) == 0) {
    base = digits[1] == 'b' ? 2 : 16;
    digits.erase(0, 2);
  } else if (digits.size() > 1 && digits[0] == '0') {
    base = 8;
  }
  try {
    const std::int64_t number = std::stoll(digits, nullptr, base);
    return negative ? -number : number;
  } catch (const std::logic_error&) {  // too large, or nothing but underscores
    return std::nullopt;
  }
}

std::optional<double> asFloat(const std::string& text) {
  static const std::regex kFloat(
      "[-+]?[0-9][0-9_]*\\.[0-9_]*([eE][-+][0-9]+)?|\\.[0-9][0-9_]*([eE][-+][0-9]+)?");
  static const std::regex kBase60("[-+]?[0-9][0-9_]*(:[0-5]?[0-9])+\\.[0-9_]*");
  static const std::regex kInfinite("[-+]?\\.(inf|Inf|INF)");
  static const std::regex kNan("\\.(nan|NaN|NAN)");
  if (matches(text, kNan)) return std::numeric_limits<double>::quiet_NaN();
  if (matches(text, kInfinite)) {
    const double infinity = std::numeric_limits<double>::infinity();
    return text[0] == '-' ? -infinity : infinity;
  }
  if (matches(text, kFloat)) return decimalNumber(withoutUnderscores(text));
  if (!matches(text, kBase60)) return std::nullopt;
  std::string digits = withoutUnderscores(text);
  const bool negative = takeMinus(digits);
  const double number = fromBase60WithFraction(digits);
  return negative ? -number : number;
}

std::optional<double> decimalNumber(const std::string& text) {
  static const std::regex kDecimal("[-+]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)?");
  if (!matches(text, kDecimal)) return std::nullopt;
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double number = 0.0;
  stream >> number;
  if (!stream.fail()) return number;
  // Too large: the stream returns the largest double, Python infinity.
  const double infinity = std::numeric_limits<double>::infinity();
  return number < 0.0 ? -infinity : infinity;
}

bool isTimestamp(const std::string& text) {
  static const std::regex kDate("[0-9]{4}-[0-9]{2}-[0-9]{2}");
  static const std::regex kDateAndTime(
      "[0-9]{4}-[0-9]{1,2}-[0-9]{1,2}([Tt]|[ \\t]+)[0-9]{1,2}:[0-9]{2}:[0-9]{2}(\\.[0-9]*)?"
      "([ \\t]*(Z|[-+][0-9]{1,2}(:[0-9]{2})?))?");
  return matches(text, kDate) || matches(text, kDateAndTime);
}

Value plainScalar(const std::string& text) {
  if (text.size() > kLongestNumber) return text;
  if (const auto value = asBool(text)) return *value;
  if (const auto value = asFloat(text)) return *value;
  if (const auto value = asInteger(text)) return *value;
  return text;
}

}  // namespace synthetic_dataset::base

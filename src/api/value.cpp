#include "synthetic_dataset/value.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {
inline namespace v2 {
namespace {

std::string scientific(double number, int digits) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream << std::scientific << std::setprecision(digits - 1) << number;
  return stream.str();
}

bool readsBackAs(const std::string& text, double number) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double read = 0.0;
  return (stream >> read) && read == number;
}

/// A double as printed by Python's repr(): the shortest text that reads back as the same number,
/// with ".0" if it would look like an integer, and with an exponent from 1e16 on and below 1e-4.
std::string pythonFloat(double number) {
  if (std::isnan(number)) return "nan";
  if (std::isinf(number)) return number > 0 ? "inf" : "-inf";
  constexpr int kMostDigits = std::numeric_limits<double>::max_digits10;
  int digits = 1;
  while (digits < kMostDigits && !readsBackAs(scientific(number, digits), number)) ++digits;
  const std::string text = scientific(number, digits);
  const int exponent = std::stoi(text.substr(text.find('e') + 1));
  if (number != 0.0 && (exponent >= 16 || exponent < -4)) return text;
  return fixed(number, std::max(digits - 1 - exponent, 1));
}

struct TextOf {
  std::string operator()(std::monostate) const { return "null"; }
  std::string operator()(bool value) const { return value ? "True" : "False"; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const { return pythonFloat(value); }
  std::string operator()(const std::string& value) const { return value; }
  std::string operator()(const Value::List& list) const {
    std::string text;
    for (const Value& entry : list) text += (text.empty() ? "" : ", ") + entry.text();
    return "[" + text + "]";
  }
  std::string operator()(const Value::Map& map) const {
    std::string text;
    for (const auto& [name, entry] : map) {
      text += (text.empty() ? "" : ", ") + name + ": " + entry.text();
    }
    return "{" + text + "}";
  }
};

struct KindOf {
  std::string operator()(std::monostate) const { return "nothing"; }
  std::string operator()(bool) const { return "a true/false value"; }
  std::string operator()(std::int64_t) const { return "a whole number"; }
  std::string operator()(double) const { return "a number"; }
  std::string operator()(const std::string&) const { return "a text"; }
  std::string operator()(const Value::List&) const { return "a list"; }
  std::string operator()(const Value::Map&) const { return "a group"; }
};

}  // namespace

std::string Value::text() const { return std::visit(TextOf{}, data_); }

std::string Value::kind() const { return std::visit(KindOf{}, data_); }

}  // namespace v2
}  // namespace synthetic_dataset

#include "base/angle_expression.h"

#include <cmath>

#include "base/yaml_scalar.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace {

constexpr int kDeepestBrackets = 32;

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Python's grammar of arithmetic (https://docs.python.org/3/reference/expressions.html):
///   sum = product {("+" | "-") product}      product = signed {("*" | "/") signed}
///   signed = ("+" | "-") signed | power      power = atom ["**" signed]
class Expression {
 public:
  explicit Expression(const std::string& text) : text_(text) {}

  double value() {
    const double value = sum();
    if (peek() != '\0') fail();
    if (!std::isfinite(value)) fail();
    return value;
  }

 private:
  [[noreturn]] void fail() const {
    throw Error("found the angle '" + text_ +
                "'; it should be made of numbers, pi, + - * / ** and parentheses, such as pi/2");
  }

  /// The next character that is not a space; '\0' at the end.
  char peek() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  bool take(const std::string& token) {
    (void)peek();
    if (text_.compare(at_, token.size(), token) != 0) return false;
    at_ += token.size();
    return true;
  }

  double sum() {
    double value = product();
    while (true) {
      if (take("+")) {
        value += product();
      } else if (take("-")) {
        value -= product();
      } else {
        return value;
      }
    }
  }

  double product() {
    double value = withSign();
    while (true) {
      if (take("*")) {
        value *= withSign();
      } else if (take("/")) {
        const double divisor = withSign();
        if (divisor == 0.0) fail();
        value /= divisor;
      } else {
        return value;
      }
    }
  }

  double withSign() {
    if (++depth_ > kDeepestBrackets) fail();
    double value = 0.0;
    if (take("-")) {
      value = -withSign();
    } else {
      value = take("+") ? withSign() : power();
    }
    --depth_;
    return value;
  }

  double power() {
    const double base = atom();
    return take("**") ? std::pow(base, withSign()) : base;
  }

  double atom() {
    if (take("(")) {
      const double value = sum();
      if (!take(")")) fail();
      return value;
    }
    if (take("pi")) return M_PI;
    return number();
  }

  double number() {
    (void)peek();
    const std::size_t begin = at_;
    while (at_ < text_.size() && (isDigit(text_[at_]) || text_[at_] == '.')) ++at_;
    if (at_ > begin && at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      ++at_;
      if (at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+')) ++at_;
      while (at_ < text_.size() && isDigit(text_[at_])) ++at_;
    }
    const auto value = decimalNumber(text_.substr(begin, at_ - begin));
    if (!value) fail();
    return *value;
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

double radians(const std::string& expression) { return Expression(expression).value(); }

double degrees(const std::string& number) {
  const std::size_t begin = number.find_first_not_of(" \t");
  const std::size_t end = number.find_last_not_of(" \t");
  const auto value = begin == std::string::npos
                         ? std::nullopt
                         : decimalNumber(number.substr(begin, end - begin + 1));
  if (!value || !std::isfinite(*value)) {
    throw Error("found the angle '" + number + "' in degrees; it should be a number");
  }
  return *value * M_PI / 180.0;
}

}  // namespace synthetic_dataset::base

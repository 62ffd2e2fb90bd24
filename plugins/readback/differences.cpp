#include "plugins/readback/differences.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <optional>
#include <sstream>

#include "plugins/readback/files.h"

namespace synthetic_dataset::formats {
namespace {

using nlohmann::json;

constexpr std::size_t kNamed = 3;  // of many differences

std::string shown(const std::string& text) {
  constexpr std::size_t kLongest = 200;
  return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}

std::string shown(const json& value) {
  return shown(value.dump(-1, ' ', false, json::error_handler_t::replace));
}

/// Of values that are no lists or objects.
bool areEqual(const json& found, const json& right) {
  if (right.is_number_float()) {
    return found.is_number() && areNear(found.get<double>(), right.get<double>());
  }
  // Which of the two kinds of whole numbers a library takes depends on the sign alone.
  if (right.is_number_integer()) return found.is_number_integer() && found == right;
  return found.type() == right.type() && found == right;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::optional<double> number(const std::string& word) {
  std::istringstream stream(word);
  stream.imbue(std::locale::classic());
  double value = 0.0;
  if (stream >> value && stream.eof()) return value;
  return std::nullopt;
}

/// What one in the last of a word's decimals is; nothing for a word that has none.
std::optional<double> lastDecimal(const std::string& word) {
  const std::size_t point = word.find('.');
  if (point == std::string::npos || !number(word)) return std::nullopt;
  const std::size_t end = word.find_first_not_of("0123456789", point + 1);
  const std::size_t decimals = (end == std::string::npos ? word.size() : end) - point - 1;
  return std::pow(10.0, -static_cast<double>(decimals));
}

bool areEqual(const std::string& found, const std::string& right) {
  if (found == right) return true;
  const std::optional<double> step = lastDecimal(right);
  const std::optional<double> value = step ? number(found) : std::nullopt;
  if (!value) return false;
  constexpr double kOneStep = 1.001;  // as floating point has it
  constexpr double kRelative = 1e-9;  // of large numbers less is known than their decimals say
  const double exact = *number(right);
  return std::abs(*value - exact) <= kOneStep * *step + kRelative * std::abs(exact);
}

}  // namespace

void Differences::add(const std::string& where, const std::string& found,
                      const std::string& right) {
  add(where + ": found " + shown(found) + "; it should be " + shown(right));
}

void Differences::add(const std::string& line) {
  if (++count_ <= kNamed) lines_.push_back(line);
}

std::vector<std::string> Differences::lines() const {
  std::vector<std::string> lines = lines_;
  if (count_ > kNamed) lines.push_back(std::to_string(count_ - kNamed) + " more values are wrong");
  return lines;
}

bool areNear(double found, double right) {
  constexpr double kTolerance = 1e-6;
  return std::abs(found - right) <= kTolerance * (1.0 + std::abs(right));
}

void compareJson(const json& found, const json& right, const std::string& where,
                 Differences& differences) {
  if (right.is_object() && found.is_object()) {
    for (const auto& each : right.items()) {
      const auto same = found.find(each.key());
      if (same == found.end()) {
        differences.add(where + ": '" + each.key() + "' is missing");
      } else {
        compareJson(*same, each.value(), where + "/" + each.key(), differences);
      }
    }
    for (const auto& each : found.items()) {
      if (right.find(each.key()) == right.end()) {
        differences.add(where + ": found '" + shown(each.key()) + "', which should not be there");
      }
    }
  } else if (right.is_array() && found.is_array()) {
    if (found.size() != right.size()) {
      differences.add(where, std::to_string(found.size()) + " entries",
                      std::to_string(right.size()));
    }
    for (std::size_t i = 0; i < std::min(found.size(), right.size()); ++i) {
      compareJson(found[i], right[i], where + "/" + std::to_string(i), differences);
    }
  } else if (!areEqual(found, right)) {
    differences.add(where, shown(found), shown(right));
  }
}

void compareText(const std::string& found, const std::string& right, const std::string& where,
                 Differences& differences) {
  if (found == right) return;
  const std::vector<std::string> found_lines = linesOf(found);
  const std::vector<std::string> right_lines = linesOf(right);
  if (found_lines.size() != right_lines.size()) {
    differences.add(where, std::to_string(found_lines.size()) + " lines",
                    std::to_string(right_lines.size()));
  }
  for (std::size_t i = 0; i < std::min(found_lines.size(), right_lines.size()); ++i) {
    const std::vector<std::string> words = wordsOf(found_lines[i]);
    const std::vector<std::string> right_words = wordsOf(right_lines[i]);
    const std::string line = where + ", line " + std::to_string(i + 1);
    if (words.size() != right_words.size()) {
      differences.add(line, "'" + found_lines[i] + "'", "'" + right_lines[i] + "'");
      continue;
    }
    for (std::size_t k = 0; k < words.size(); ++k) {
      if (areEqual(words[k], right_words[k])) continue;
      differences.add(line, "'" + words[k] + "'", "'" + right_words[k] + "'");
    }
  }
}

}  // namespace synthetic_dataset::formats

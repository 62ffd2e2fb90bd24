#include "plugins/readback/differences.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <locale>
#include <optional>
#include <sstream>

#include "plugins/shared/json.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats {
namespace {

using nlohmann::json;

constexpr std::size_t kNamed = 3;  // number listed of many differences

std::string shown(const std::string& text) {
  constexpr std::size_t kLongest = 200;
  return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}

std::string shown(const json& value) {
  return shown(value.dump(-1, ' ', false, json::error_handler_t::replace));
}

/// Whether two numbers are equal up to rounding in text and in sums. An angle of half a turn has
/// two representations.
bool areNear(double found, double right) {
  constexpr double kTolerance = 1e-6;
  const auto isNear = [&](double number) {
    return std::abs(found - number) <= kTolerance * (1.0 + std::abs(number));
  };
  return isNear(right) || (std::abs(std::abs(right) - M_PI) <= kTolerance && isNear(-right));
}

/// Compares values that are neither lists nor objects.
bool areEqual(const json& found, const json& right) {
  if (right.is_number_float()) {
    return found.is_number() && areNear(found.get<double>(), right.get<double>());
  }
  // Which of the two integer types the library uses depends only on the sign.
  if (right.is_number_integer()) return found.is_number_integer() && found == right;
  return found.type() == right.type() && found == right;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// A line's words and punctuation marks.
std::vector<std::string> wordsAndMarksOf(const std::string& line) {
  constexpr const char* kBlanks = " \t\r";
  constexpr const char* kEnds = " \t\r,;:=<>()[]{}\"'";
  std::vector<std::string> words;
  for (std::size_t at = 0; (at = line.find_first_not_of(kBlanks, at)) != std::string::npos;) {
    const std::size_t end = std::max(at + 1, std::min(line.size(), line.find_first_of(kEnds, at)));
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

std::optional<double> number(const std::string& word) {
  std::istringstream stream(word);
  stream.imbue(std::locale::classic());
  double value = 0.0;
  if (stream >> value && stream.eof()) return value;
  return std::nullopt;
}

/// How far a number may differ from one written like this; nothing if the word is not a number with
/// decimals.
std::optional<double> toleranceOf(const std::string& word) {
  const std::size_t point = word.find('.');
  if (point == std::string::npos || !number(word)) return std::nullopt;
  const std::size_t end = word.find_first_not_of("0123456789", point + 1);
  const std::size_t decimals = (end == std::string::npos ? word.size() : end) - point - 1;
  constexpr std::size_t kMany = 10;  // decimals of a number written in full precision
  if (decimals >= kMany) return 1e-6;
  constexpr double kOneStep = 1.001;  // allows for floating-point rounding
  return kOneStep * std::pow(10.0, -static_cast<double>(decimals));
}

bool areEqual(const std::string& found, const std::string& right) {
  if (found == right) return true;
  const std::optional<double> tolerance = toleranceOf(right);
  const std::optional<double> value = tolerance ? number(found) : std::nullopt;
  if (!value) return false;
  const double exact = *number(right);
  constexpr double kRelative = 1e-9;  // large numbers are less precise than their decimals suggest
  const double most = *tolerance + kRelative * std::abs(exact);
  const bool is_half_turn = std::abs(std::abs(exact) - M_PI) <= most;
  return std::abs(*value - exact) <= most || (is_half_turn && std::abs(*value + exact) <= most);
}

void compareLine(const std::string& found, const std::string& right, const std::string& where,
                 Differences& differences, const std::string* other) {
  const std::vector<std::string> words = wordsAndMarksOf(found);
  const std::vector<std::string> right_words = wordsAndMarksOf(right);
  const std::vector<std::string> other_words = wordsAndMarksOf(other != nullptr ? *other : right);
  if (other_words.size() != right_words.size()) return;  // unknown which is right
  if (words.size() != right_words.size()) {
    differences.add(where, "'" + shown(found) + "'", "'" + shown(right) + "'");
    return;
  }
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (right_words[i] != other_words[i] || areEqual(words[i], right_words[i])) continue;
    differences.add(where, "'" + words[i] + "'", "'" + right_words[i] + "'");
  }
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Whether two values that may not actually be numbers are equal except for their last digits:
/// bytes of other data appear as tiny or huge numbers.
bool areTheSameNumber(double one, double other) {
  constexpr double kNothing = 1e-9;
  constexpr double kTiny = 1e-30;
  constexpr double kHuge = 1e12;
  const auto isNothing = [](double number) {
    return number == 0.0 || (std::abs(number) > kTiny && std::abs(number) < kNothing);
  };
  if (isNothing(one) && isNothing(other)) return true;
  return std::abs(one) >= kNothing && std::abs(one) < kHuge &&
         std::abs(one - other) <= kNothing * std::abs(one);
}

/// Whether both contain such nearly equal 64-bit numbers at a position.
bool areNearAt(std::size_t at, const std::string& found, const std::string& right) {
  double one = 0.0;
  double two = 0.0;
  if (at + sizeof one > right.size()) return false;
  std::memcpy(&one, found.data() + at, sizeof one);
  std::memcpy(&two, right.data() + at, sizeof two);
  return areTheSameNumber(one, two);
}

/// @param first  offset at which 64-bit numbers begin; nothing: they may be anywhere
void compareNumbers(const std::string& found, const std::string& right,
                    const std::optional<std::size_t>& first, const std::string& where,
                    Differences& differences) {
  if (found.size() != right.size()) {
    differences.add(where, std::to_string(found.size()) + " bytes", std::to_string(right.size()));
    return;
  }
  for (std::size_t i = 0; i < right.size(); ++i) {
    if (found[i] == right[i]) continue;
    // A number's least significant bytes come first in memory.
    std::size_t at = first ? i - (i - std::min(i, *first)) % sizeof(double) : i;
    while (!first && at > 0 && i - at < sizeof(double) - 1 && !areNearAt(at, found, right)) --at;
    if ((first && i < *first) || !areNearAt(at, found, right)) {
      differences.add(where + ": found another byte at " + std::to_string(i));
      return;
    }
    i = at + sizeof(double) - 1;
  }
}

/// Compares a line as JSON if it is JSON, otherwise as text.
void compareRecordLine(const std::string& found, const std::string& right, const std::string& where,
                       Differences& differences, const std::string& other) {
  const json one = jsonIfAny(found);
  const json two = jsonIfAny(right);
  const json another = jsonIfAny(other);
  if (one.is_structured() && two.is_structured() && another.is_structured()) {
    compareJson(one, two, where, differences, &another);
  } else {
    compareLine(found, right, where, differences, &other);
  }
}

void compareRecordLines(const std::string& found, const std::string& right,
                        const std::string& where, Differences& differences,
                        const std::string* other) {
  const std::vector<std::string> lines = linesOf(found);
  const std::vector<std::string> right_lines = linesOf(right);
  const std::vector<std::string> others = linesOf(other != nullptr ? *other : right);
  if (lines.size() != right_lines.size() || others.size() != right_lines.size()) {
    if (others.size() == right_lines.size()) {
      differences.add(where, "'" + found + "'", "'" + right + "'");
    }
    return;
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i] != right_lines[i]) {
      compareRecordLine(lines[i], right_lines[i], where, differences, others[i]);
    }
  }
}

void compareJsonLines(const std::string& found, const std::string& right, const std::string& name,
                      Differences& differences, const std::string* other) {
  const std::vector<std::string> lines = linesOf(found);
  const std::vector<std::string> right_lines = linesOf(right);
  const std::vector<std::string> others = linesOf(other != nullptr ? *other : right);
  if (lines.size() != right_lines.size()) {
    differences.add(name, std::to_string(lines.size()) + " lines",
                    std::to_string(right_lines.size()));
  }
  for (std::size_t i = 0; i < std::min({lines.size(), right_lines.size(), others.size()}); ++i) {
    if (lines[i] == right_lines[i]) continue;
    const json another = parsedJson<json>(others[i]);
    compareJson(parsedJson<json>(lines[i]), parsedJson<json>(right_lines[i]),
                name + ", line " + std::to_string(i + 1), differences, &another);
  }
}

}  // namespace

bool isText(const std::string& bytes) {
  return std::none_of(bytes.begin(), bytes.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20U && c != '\n' && c != '\r' && c != '\t';
  });
}

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

void compareJson(const json& found, const json& right, const std::string& where,
                 Differences& differences, const json* other) {
  const json& another = other != nullptr ? *other : right;
  if (another.type() != right.type()) return;
  if (right.is_object() && found.is_object()) {
    for (const auto& each : right.items()) {
      const auto same = found.find(each.key());
      const auto of_other = another.find(each.key());
      if (same == found.end()) {
        differences.add(where + ": '" + each.key() + "' is missing");
      } else if (of_other != another.end()) {
        compareJson(*same, each.value(), where + "/" + each.key(), differences, &*of_other);
      }
    }
    for (const auto& each : found.items()) {
      if (right.find(each.key()) == right.end()) {
        differences.add(where + ": found '" + shown(each.key()) + "', which should not be there");
      }
    }
  } else if (right.is_array() && found.is_array()) {
    if (another.size() != right.size()) return;
    if (found.size() != right.size()) {
      differences.add(where, std::to_string(found.size()) + " entries",
                      std::to_string(right.size()));
    }
    for (std::size_t i = 0; i < std::min(found.size(), right.size()); ++i) {
      compareJson(found[i], right[i], where + "/" + std::to_string(i), differences, &another[i]);
    }
  } else if (another == right && !areEqual(found, right)) {
    differences.add(where, shown(found), shown(right));
  }
}

void compareText(const std::string& found, const std::string& right, const std::string& where,
                 Differences& differences, const std::string* other) {
  if (found == right) return;
  const std::vector<std::string> found_lines = linesOf(found);
  const std::vector<std::string> right_lines = linesOf(right);
  const std::vector<std::string> others = linesOf(other != nullptr ? *other : right);
  if (others.size() != right_lines.size()) return;
  if (found_lines.size() != right_lines.size()) {
    differences.add(where, std::to_string(found_lines.size()) + " lines",
                    std::to_string(right_lines.size()));
  }
  for (std::size_t i = 0; i < std::min(found_lines.size(), right_lines.size()); ++i) {
    if (found_lines[i] == right_lines[i]) continue;
    compareLine(found_lines[i], right_lines[i], where + ", line " + std::to_string(i + 1),
                differences, &others[i]);
  }
}

void compareContents(const std::string& found, const std::string& right, const std::string& name,
                     Differences& differences, const std::string* other) {
  if (found == right) return;
  try {
    if (endsWith(name, ".json")) {
      const json another = parsedJson<json>(other != nullptr ? *other : right);
      compareJson(parsedJson<json>(found), parsedJson<json>(right), name, differences, &another);
    } else if (endsWith(name, ".jsonl")) {
      compareJsonLines(found, right, name, differences, other);
    } else if (isText(right)) {
      compareText(found, right, name, differences, other);
    } else if (other != nullptr && *other != right) {
      return;
    } else if (endsWith(name, ".npy") && right.find("'<f8'") != std::string::npos) {
      compareNumbers(found, right, right.find('\n') + 1, name, differences);
    } else {
      differences.add(name + ": found other bytes");
    }
  } catch (const json::exception& error) {
    throw Error("'" + name + "': " + error.what());
  } catch (const UnfitJson& error) {
    throw Error("'" + name + "': " + error.what());
  }
}

void compareRecords(const std::string& found, const std::string& right, const std::string& where,
                    Differences& differences, const std::string* other) {
  if (found == right) return;
  if (isText(right)) {
    compareRecordLines(found, right, where, differences, other);
  } else if (other == nullptr || *other == right) {
    compareNumbers(found, right, std::nullopt, where, differences);
  }
}

}  // namespace synthetic_dataset::formats

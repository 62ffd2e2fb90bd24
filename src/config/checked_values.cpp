#include "config/checked_values.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>

#include "randomize/appearance/picture_options.h"

namespace synthetic_dataset::config {
namespace {

bool isControl(char character) {
  const auto code = static_cast<unsigned char>(character);
  return code < 0x20U || code == 0x7FU;
}

/// The number of bytes of a UTF-8 character, by its first byte (RFC 3629, section 4); 0 if that is
/// invalid.
std::size_t lengthOf(unsigned char first) {
  if (first < 0x80U) return 1;
  if (first >= 0xC2U && first < 0xE0U) return 2;
  if (first >= 0xE0U && first < 0xF0U) return 3;
  return first >= 0xF0U && first < 0xF5U ? 4 : 0;
}

/// Whether a character with these first two bytes is neither overlong, nor a surrogate, nor beyond
/// the last code point.
bool isSecond(unsigned char first, unsigned char second) {
  if (first == 0xE0U) return second >= 0xA0U;
  if (first == 0xEDU) return second < 0xA0U;
  if (first == 0xF0U) return second >= 0x90U;
  return first != 0xF4U || second < 0x90U;
}

bool isUtf8(const std::string& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = lengthOf(byte(at));
    if (length == 0 || length > text.size() - at) return false;
    for (std::size_t i = 1; i < length; ++i) {
      if ((byte(at + i) & 0xC0U) != 0x80U) return false;
    }
    if (length > 1 && !isSecond(byte(at), byte(at + 1))) return false;
    at += length;
  }
  return true;
}

}  // namespace

double numberAbove(Parameters& group, const std::string& name, double fallback, double limit) {
  const double number = group.optional(name, fallback);
  if (number > limit) return number;
  group.addError(name,
                 "found " + Value(number).text() + "; it should be above " + Value(limit).text());
  return fallback;
}

void refuseWithout(Parameters& group, const std::vector<std::string>& names,
                   const std::string& needed) {
  for (const std::string& name : names) {
    if (!group.has(name)) continue;
    group.addError(name, "has a meaning with " + needed + " alone");
    group.ignore(name);
  }
}

std::optional<std::int64_t> maybeSceneCount(Parameters& group, const std::string& name) {
  return group.maybeBetween<std::int64_t>(name, 1, 100000000);
}

std::optional<double> maybeSeconds(Parameters& group, const std::string& name) {
  return group.maybeBetween(name, 0.0, 1e9);
}

std::vector<std::string> readNames(Parameters& group, const std::string& name,
                                   const std::string& of) {
  const auto value = group.required<Value>(name);
  const Value::List* list = value.as<Value::List>();
  std::vector<std::string> names;
  for (const Value& each : list != nullptr ? *list : Value::List{value}) {
    const bool is_name = each.is<std::string>() || each.is<std::int64_t>();
    if (is_name && !each.text().empty()) names.push_back(each.text());
  }
  if (names.empty() || (list != nullptr && names.size() != list->size())) {
    group.addError(name, "found " + value.text() + "; it should be a list of names of " + of);
  }
  return names;
}

std::string absolutePath(const std::string& path) {
  if (path.empty()) return path;
  std::filesystem::path result = path;
  const char* home = std::getenv("HOME");
  if (home != nullptr && path.rfind("~/", 0) == 0) {
    result = std::filesystem::path(home) / path.substr(2);
  }
  return std::filesystem::absolute(result).lexically_normal().string();
}

std::string folderPath(const std::string& path) {
  std::string result = absolutePath(path);
  if (!result.empty() && result.back() != '/') result += '/';
  return result;
}

std::string picturesFrom(const std::string& text) {
  const bool is_word = text == randomize::kProcedural || text == randomize::kNatural;
  return is_word ? text : absolutePath(text);
}

std::string pathOrUri(const std::string& text) {
  return text.find("://") == std::string::npos ? absolutePath(text) : text;
}

bool isEmptyList(Parameters& group, const std::string& name) {
  const auto given = group.maybe<Value>(name);
  const auto* list = given ? given->as<Value::List>() : nullptr;
  return list != nullptr && list->empty();
}

std::optional<std::string> nameProblem(const std::string& text) {
  if (text.empty()) return "is empty";
  if (text.find_first_of("\n\r") != std::string::npos) return "has more than one line";
  if (std::any_of(text.begin(), text.end(), isControl)) return "has a control character";
  if (!isUtf8(text)) return "is not UTF-8";
  return std::nullopt;
}

}  // namespace synthetic_dataset::config

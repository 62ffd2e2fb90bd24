#include "world/mesh/obj_repair.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

#include "world/files/text.h"

namespace synthetic_dataset::world {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

constexpr std::string_view kLibraries = "mtllib";

/// The longest line with a name [byte].
constexpr std::size_t kLongestStatement = 4096;

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Whether a number such as ".4" or "-.4" begins at `at`, which is moved to its point then.
bool beginsWithPoint(std::string_view line, std::size_t& at) {
  std::size_t point = at;
  if (point < line.size() && (line[point] == '-' || line[point] == '+')) ++point;
  if (point + 1 >= line.size() || line[point] != '.' || !isDigit(line[point + 1])) return false;
  at = point;
  return true;
}

/// Appends "v .4 0 -.3" as "v 0.4 0 -0.3".
void appendNumbers(std::string_view line, std::string& to) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool begins = i > 0 && isBlank(line[i - 1]);
    std::size_t point = i;
    if (begins && beginsWithPoint(line, point)) {
      to.append(line.substr(i, point - i)).append("0");
      i = point;
    }
    to += line[i];
  }
}

std::string_view withoutBlanksBehind(std::string_view line) {
  while (!line.empty() && isBlank(line.back())) line.remove_suffix(1);
  return line;
}

/// The text with each line passed through `treat`, without blanks at the end of lines or a byte
/// order mark.
template <class Treat>
std::string eachLine(const std::string& text, const Treat& treat) {
  std::string_view rest = text;
  if (startsWith(rest, kByteOrderMark)) rest.remove_prefix(kByteOrderMark.size());
  std::string result;
  result.reserve(text.size() + text.size() / 16);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    treat(withoutBlanksBehind(rest.substr(0, end)), result);
    rest.remove_prefix(end);
    if (rest.empty()) break;
    result += '\n';
    rest.remove_prefix(1);
  }
  return result;
}

/// Whether a line begins with a keyword: "vt 0 1".
bool isOf(std::string_view line, std::string_view keyword) {
  return startsWith(line, keyword) && line.size() > keyword.size() && isBlank(line[keyword.size()]);
}

bool hasLineOf(std::string_view keyword, const std::string& text) {
  bool has_one = false;
  eachLine(text,
           [&](std::string_view line, std::string&) { has_one = has_one || isOf(line, keyword); });
  return has_one;
}

/// Appends a face's corners "1/2/3" without the indices of what the file does not have: "1//3",
/// "1".
/// @param keeps  whether the file has texture coordinates, and normals
void appendCorners(std::string_view line, const std::array<bool, 2>& keeps, std::string& to) {
  std::size_t slash = 0;  // number of slashes so far in this corner
  std::string pending;    // slashes that no index has followed yet
  for (const char c : line) {
    if (c == '/') {
      ++slash;
      pending += c;
      continue;
    }
    if (isBlank(c)) {
      slash = 0;
      pending.clear();
    } else if (slash > 0 && (slash > keeps.size() || !keeps[slash - 1])) {
      continue;
    }
    to += pending;
    pending.clear();
    to += c;
  }
}

/// The names in "two.mtl my own.mtl": a name may contain blanks, and the next one begins after
/// ".mtl".
std::vector<std::string> libraryNames(const std::string& names) {
  std::vector<std::string> found;
  std::size_t begin = 0;
  for (std::size_t i = 4; i < names.size(); ++i) {
    const std::string ending = names.substr(i - 4, 4);
    if (!isBlank(names[i]) || (ending != ".mtl" && ending != ".MTL")) continue;
    found.push_back(trimmed(names.substr(begin, i - begin)));
    begin = i;
  }
  found.push_back(trimmed(names.substr(begin)));
  return found;
}

/// The text after a keyword, for each line that begins with it.
std::vector<std::string> namesAfter(std::string_view keyword, const std::string& text) {
  std::vector<std::string> names;
  eachLine(text, [&](std::string_view line, std::string&) {
    const std::string statement = trimmed(std::string(line.substr(0, kLongestStatement)));
    if (startsWith(statement, keyword)) names.push_back(trimmed(statement.substr(keyword.size())));
  });
  return names;
}

}  // namespace

std::string repairedObj(const std::string& text) {
  const std::array<bool, 2> keeps = {hasLineOf("vt", text), hasLineOf("vn", text)};
  const bool has_all = keeps[0] && keeps[1];
  return eachLine(text, [&](std::string_view line, std::string& to) {
    if (!line.empty() && line.front() == 'v') {
      appendNumbers(line, to);
    } else if (!has_all && isOf(line, "f")) {
      appendCorners(line, keeps, to);
    } else if (isOf(line, kLibraries)) {
      std::string_view newline;
      for (const std::string& name : libraryNames(std::string(line.substr(kLibraries.size())))) {
        to.append(newline).append(kLibraries).append(" ").append(name);
        newline = "\n";
      }
    } else {
      to += line;
    }
  });
}

std::string repairedMtl(const std::string& text) {
  return eachLine(text, [](std::string_view line, std::string& to) { to += line; });
}

std::vector<std::string> librariesOfObj(const std::string& text) {
  std::vector<std::string> libraries;
  for (const std::string& names : namesAfter(kLibraries, text)) {
    for (std::string& name : libraryNames(names)) libraries.push_back(std::move(name));
  }
  return libraries;
}

std::vector<std::string> materialsOfMtl(const std::string& text) {
  return namesAfter("newmtl", text);
}

}  // namespace synthetic_dataset::world

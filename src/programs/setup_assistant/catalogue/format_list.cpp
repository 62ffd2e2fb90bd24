#include "programs/setup_assistant/catalogue/format_list.h"

#include <cctype>
#include <map>
#include <regex>
#include <sstream>
#include <vector>

#include "plugins/readback/format.h"
#include "programs/setup_assistant/catalogue/formats_document.h"

namespace synthetic_dataset::programs {
namespace {

/// The cells of a line of a table.
std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');) {
    const std::size_t begin = cell.find_first_not_of(' ');
    const std::size_t end = cell.find_last_not_of(' ');
    cells.push_back(begin == std::string::npos ? "" : cell.substr(begin, end + 1 - begin));
  }
  return cells;
}

/// As links to headings name them: small letters, dashes for spaces.
std::string anchorOf(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    if (c == ' ') anchor += '-';
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_') {
      anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return anchor;
}

/// The lines of each section, by its anchor; those before the first heading by "".
std::map<std::string, std::vector<std::string>> sectionsOf(const std::string& document) {
  std::map<std::string, std::vector<std::string>> sections;
  std::istringstream stream(document);
  std::string section;
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("## ", 0) == 0) section = anchorOf(line.substr(3));
    sections[section].push_back(line);
  }
  return sections;
}

/// "... (`true`)": what a description says in parentheses at its end, or of its default.
std::string defaultIn(const std::string& text) {
  static const std::regex kDefault(R"(\(`([^`]+)`\)|\(([0-9.]+)\)|[Dd]efault:? `?([^`.,;]+)`?)");
  std::smatch match;
  if (!std::regex_search(text, match, kDefault)) return "";
  for (std::size_t i = 1; i < match.size(); ++i) {
    if (match[i].matched) return match[i];
  }
  return "";
}

Value::List optionsIn(const std::vector<std::string>& lines) {
  static const std::regex kName("`([a-z][a-z_0-9/]*)`");
  Value::List options;
  bool is_settings = false;
  for (const std::string& line : lines) {
    if (line.empty() || line.front() != '|') {
      is_settings = false;
      continue;
    }
    const std::vector<std::string> cells = cellsOf(line);
    if (cells.front() == "setting") is_settings = true;
    if (!is_settings || cells.size() < 2) continue;
    for (std::sregex_iterator name(cells[0].begin(), cells[0].end(), kName), end; name != end;
         ++name) {
      options.push_back(Value::Map{{"name", Value((*name)[1].str())},
                                   {"default", Value(defaultIn(cells[1]))},
                                   {"text", Value(cells[1])}});
    }
  }
  return options;
}

std::string nameOfType(const std::string& type) {
  for (const auto& [name, known] : formats::formatNames()) {
    if (known == type) return name;
  }
  return type.substr(type.find('/') + 1);
}

}  // namespace

Value formatList(const std::string& document) {
  static const std::regex kType(R"(\[`([^`]+)`\]\(#([^)]+)\))");
  const auto sections = sectionsOf(document);
  Value::List list;
  const auto start = sections.find("");
  if (start == sections.end()) return Value::Map{{"formats", Value(list)}};
  for (const std::string& line : start->second) {
    std::smatch match;
    if (line.rfind("| [", 0) != 0 || !std::regex_search(line, match, kType)) continue;
    const std::vector<std::string> cells = cellsOf(line);
    const auto section = sections.find(match[2]);
    list.push_back(Value::Map{
        {"name", Value(nameOfType(match[1]))},
        {"type", Value(match[1].str())},
        {"text", Value(cells.size() > 1 ? cells[1] : "")},
        {"read_by", Value(cells.size() > 2 ? cells[2] : "")},
        {"options",
         Value(section == sections.end() ? Value::List{} : optionsIn(section->second))}});
  }
  return Value::Map{{"formats", Value(list)}};
}

const std::string& formatsDocument() {
  static const std::string kDocument = kFormatsDocument;
  return kDocument;
}

}  // namespace synthetic_dataset::programs

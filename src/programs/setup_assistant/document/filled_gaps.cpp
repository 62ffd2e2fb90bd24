#include "programs/setup_assistant/document/filled_gaps.h"

#include <optional>
#include <sstream>
#include <variant>
#include <vector>

#include "base/yaml_text/yaml_edit.h"
#include "base/yaml_text/yaml_splicer.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace {

const std::string kGap = "# TODO";

std::size_t indentOf(const std::string& line) {
  const std::size_t indent = line.find_first_not_of(' ');
  return indent == std::string::npos ? line.size() : indent;
}

bool isBlank(const std::string& line) { return indentOf(line) == line.size(); }

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// The line in which a setting's value ends.
std::optional<std::size_t> lineOf(const std::string& text, const std::string& origin,
                                  const base::YamlPath& path) {
  const base::YamlSplicer splicer(text, origin);
  if (!splicer.has(path)) return std::nullopt;
  const std::size_t end = splicer.replace(path, Value("x")).end;
  const std::size_t last = end > 0 && text[end - 1] == '\n' ? end - 1 : end;
  std::size_t line = 0;
  for (std::size_t i = 0; i < last; ++i) line += text[i] == '\n' ? 1 : 0;
  return line;
}

/// Whether a line is a setting that is commented out, with the remark that it is to be chosen.
bool isGapOf(const std::string& line, const std::string& name) {
  const std::size_t begin = indentOf(line);
  return line.compare(begin, name.size() + 3, "# " + name + ":") == 0 &&
         line.find(kGap) != std::string::npos;
}

void removeFromEnd(std::string& line) {
  const std::size_t gap = line.rfind(kGap);
  if (gap == std::string::npos || gap == 0 || line[gap - 1] != ' ') return;
  line.erase(line.find_last_not_of(' ', gap - 1) + 1);
}

/// Removes the lines in which the setting is commented out from the group around a line.
void removeAround(std::vector<std::string>& lines, std::size_t at, const std::string& name) {
  const std::size_t indent = indentOf(lines[at]);
  const auto isOutside = [&](const std::string& line) {
    return !isBlank(line) && indentOf(line) < indent;
  };
  std::size_t begin = at;
  while (begin > 0 && !isOutside(lines[begin - 1])) --begin;
  std::size_t end = at + 1;
  while (end < lines.size() && !isOutside(lines[end])) ++end;
  for (std::size_t i = end; i-- > begin;) {
    if (indentOf(lines[i]) == indent && isGapOf(lines[i], name)) {
      lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
}

/// Whether only comments differ: a quoted text may look like a remark.
bool saysTheSame(const std::string& a, const std::string& b, const std::string& origin) {
  try {
    return base::saysTheSame(base::readYamlText(a, origin), base::readYamlText(b, origin));
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

std::string withoutGap(const std::string& text, const std::string& origin,
                       const base::YamlPath& path) {
  if (text.find(kGap) == std::string::npos) return text;
  const auto line = lineOf(text, origin, path);
  const auto* name = path.empty() ? nullptr : std::get_if<std::string>(&path.back());
  std::vector<std::string> lines = linesOf(text);
  if (!line || *line >= lines.size() || name == nullptr) return text;
  removeFromEnd(lines[*line]);
  removeAround(lines, *line, *name);
  const std::string without = joined(lines);
  return saysTheSame(text, without, origin) ? without : text;
}

}  // namespace synthetic_dataset::programs

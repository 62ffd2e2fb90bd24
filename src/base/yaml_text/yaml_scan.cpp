#include "base/yaml_text/yaml_scan.h"

#include <algorithm>
#include <cstring>

namespace synthetic_dataset::base {
namespace {

constexpr const char* kBlanks = " \t\r\n";
constexpr const char* kFlowIndicators = ",[]{}";

}  // namespace

bool YamlScan::isAt(std::size_t offset, const char* characters) const {
  return offset < text_.size() && text_[offset] != '\0' &&
         std::strchr(characters, text_[offset]) != nullptr;
}

std::size_t YamlScan::lineBegin(std::size_t offset) const {
  if (offset == 0) return 0;
  const std::size_t before = text_.rfind('\n', offset - 1);
  return before == std::string::npos ? 0 : before + 1;
}

std::size_t YamlScan::lineEnd(std::size_t offset) const {
  const std::size_t end = std::min(text_.find('\n', offset), text_.size());
  return end > offset && text_[end - 1] == '\r' ? end - 1 : end;
}

std::size_t YamlScan::nextLine(std::size_t offset) const {
  const std::size_t end = text_.find('\n', offset);
  return end == std::string::npos ? text_.size() : end + 1;
}

std::size_t YamlScan::afterGap(std::size_t offset, const std::string& more) const {
  const std::string passed = kBlanks + more;
  while (offset < text_.size()) {
    if (text_[offset] == '#') {
      offset = lineEnd(offset);
    } else if (passed.find(text_[offset]) != std::string::npos) {
      ++offset;
    } else {
      break;
    }
  }
  return offset;
}

std::size_t YamlScan::afterProperties(std::size_t offset) const {
  while (isAt(offset, "&!")) {
    const bool is_verbatim = text_.compare(offset, 2, "!<") == 0;
    const std::size_t close = is_verbatim ? text_.find('>', offset) : std::string::npos;
    offset = close == std::string::npos ? wordEnd(offset) : close + 1;
    offset = afterGap(offset, "");
  }
  return offset;
}

std::size_t YamlScan::wordEnd(std::size_t offset) const {
  while (offset < text_.size() && !isAt(offset, kBlanks) && !isAt(offset, kFlowIndicators)) {
    ++offset;
  }
  return offset;
}

std::size_t YamlScan::lineOfWordsEnd(std::size_t offset) const {
  std::size_t end = offset;
  while (end < text_.size() && !isAt(end, "\r\n") && !isAt(end, kFlowIndicators) &&
         !(text_[end] == '#' && isAt(end - 1, " \t"))) {
    ++end;
  }
  return withoutSpaces(offset, end);
}

std::size_t YamlScan::nameEnd(std::size_t offset, bool in_flow) const {
  if (isAt(offset, "\"'")) return quotedEnd(offset);
  std::size_t end = offset;
  while (end < text_.size() && !endsPlain(end, Place::kName, in_flow)) ++end;
  return withoutSpaces(offset, end);
}

std::size_t YamlScan::markBefore(std::size_t offset, char mark) const {
  std::size_t before = offset;
  while (before > 0 && text_[before - 1] == ' ') --before;
  return before < offset && before > 0 && text_[before - 1] == mark ? before - 1 : offset;
}

std::size_t YamlScan::scalarEnd(std::size_t offset, std::ptrdiff_t indentation,
                                bool in_flow) const {
  if (isAt(offset, "\"'")) return quotedEnd(offset);
  if (!in_flow && isAt(offset, "|>")) return literalEnd(offset, indentation);
  return plainEnd(offset, indentation, in_flow ? Place::kFlow : Place::kBlock);
}

std::size_t YamlScan::quotedEnd(std::size_t offset) const {
  const char quote = text_[offset];
  for (std::size_t i = offset + 1; i < text_.size(); ++i) {
    if (quote == '"' && text_[i] == '\\') {
      ++i;
    } else if (text_[i] == quote) {
      if (quote == '"' || i + 1 >= text_.size() || text_[i + 1] != '\'') return i + 1;
      ++i;  // '' is a quote in the text
    }
  }
  return text_.size();
}

/// The end of a text after `|` or `>`: it contains all lines that are indented deeper, with empty
/// lines between them and, if it keeps those (`|+`), after them.
std::size_t YamlScan::literalEnd(std::size_t offset, std::ptrdiff_t indentation) const {
  std::size_t end = lineEnd(offset);
  const bool keeps =
      text_.substr(offset, std::min<std::size_t>(3, end - offset)).find('+') != std::string::npos;
  for (std::size_t line = nextLine(offset); line < text_.size(); line = nextLine(line)) {
    const std::size_t line_end = lineEnd(line);
    const std::size_t first = std::min(text_.find_first_not_of(' ', line), line_end);
    if (first == line_end) {
      if (keeps) end = line_end;
      continue;
    }
    if (static_cast<std::ptrdiff_t>(first - line) <= indentation) break;
    end = line_end;
  }
  return end;
}

/// A text without quotes may continue on further lines if they are indented deeper or within
/// brackets.
std::size_t YamlScan::plainEnd(std::size_t offset, std::ptrdiff_t indentation, Place place) const {
  std::size_t end = offset;
  for (std::size_t i = offset; i < text_.size();) {
    if (isAt(i, "\r\n")) {
      end = withoutSpaces(offset, i);
      const std::size_t next = std::min(text_.find_first_not_of(kBlanks, i), text_.size());
      const bool goes_on =
          next < text_.size() && text_[next] != '#' && !endsPlain(next, place, false) &&
          (place == Place::kFlow || static_cast<std::ptrdiff_t>(column(next)) > indentation);
      if (!goes_on) return end;
      i = next;
    } else if (endsPlain(i, place, false)) {
      return withoutSpaces(offset, i);
    } else {
      ++i;
    }
  }
  return withoutSpaces(offset, text_.size());
}

bool YamlScan::endsPlain(std::size_t offset, Place place, bool in_flow_name) const {
  const bool in_flow = place == Place::kFlow || in_flow_name;
  if (text_[offset] == '#') return offset > 0 && isAt(offset - 1, kBlanks);
  if (in_flow && isAt(offset, kFlowIndicators)) return true;
  if (place == Place::kName && isAt(offset, "\r\n") && !in_flow_name) return true;
  if (text_[offset] != ':' || place == Place::kBlock) return false;
  return offset + 1 == text_.size() || isAt(offset + 1, kBlanks) ||
         (in_flow && isAt(offset + 1, kFlowIndicators));
}

std::size_t YamlScan::withoutSpaces(std::size_t begin, std::size_t end) const {
  while (end > begin && isAt(end - 1, kBlanks)) --end;
  return end;
}

}  // namespace synthetic_dataset::base

#include "world/sdf/sdf_console.h"

#include <iostream>

namespace synthetic_dataset::world {
namespace {

/// A line without the terminal's colours (ECMA-48: escape, "[", up to "m").
std::string withoutColours(const std::string& line) {
  std::string result;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\x1B') {
      i = line.find('m', i);
      if (i == std::string::npos) break;
      continue;
    }
    result += line[i];
  }
  return result;
}

/// What follows `separator` in the lines that begin with `start`.
std::vector<std::string> linesAfter(const std::string& text, const std::string& start,
                                    const std::string& separator) {
  std::vector<std::string> result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    line = withoutColours(line);
    const std::size_t end = line.find(separator);
    if (line.rfind(start, 0) != 0 || end == std::string::npos) continue;
    result.push_back(line.substr(end + separator.size()));
  }
  return result;
}

}  // namespace

SdfConsole::SdfConsole()
    : cerr_buffer_(std::cerr.rdbuf(text_.rdbuf())), handler_(console_bridge::getOutputHandler()) {
  console_bridge::useOutputHandler(this);
}

SdfConsole::~SdfConsole() {
  std::cerr.rdbuf(cerr_buffer_);
  console_bridge::useOutputHandler(handler_);
}

void SdfConsole::log(const std::string& text, console_bridge::LogLevel level, const char*, int) {
  if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) urdf_errors_.push_back(text);
}

std::vector<std::string> SdfConsole::unreported() const {
  return linesAfter(text_.str(), "Error Code ", ": ");
}

std::vector<std::string> SdfConsole::reasons() const {
  std::vector<std::string> result = linesAfter(text_.str(), "Error [", "] ");
  result.insert(result.end(), urdf_errors_.begin(), urdf_errors_.end());
  return result;
}

}  // namespace synthetic_dataset::world

#include "programs/setup_assistant/run/run_log.h"

#include <optional>

#include "base/printable_text.h"
#include "base/yaml_value.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {
namespace {

/// The program writes jsonText, which parseYaml reads back.
std::optional<Value::Map> groupIn(const std::string& line) {
  if (line.empty() || line.front() != '{') return std::nullopt;
  try {
    const Value value = base::parseYaml(line, "line");
    if (const auto* map = value.as<Value::Map>()) return *map;
  } catch (const Error&) {  // a line for people that begins with a brace
  }
  return std::nullopt;
}

double numberIn(const Value::Map& map, const std::string& name) {
  const auto found = map.find(name);
  if (found == map.end()) return 0.0;
  if (const auto* number = found->second.as<double>()) return *number;
  const auto* whole = found->second.as<std::int64_t>();
  return whole == nullptr ? 0.0 : static_cast<double>(*whole);
}

std::vector<std::string> textsIn(const Value::Map& map, const std::string& name) {
  std::vector<std::string> texts;
  const auto found = map.find(name);
  const auto* list = found == map.end() ? nullptr : found->second.as<Value::List>();
  for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
    texts.push_back((*list)[i].text());
  }
  return texts;
}

}  // namespace

std::string withoutColours(const std::string& line) {
  std::string plain;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line.compare(i, 2, "\033[") != 0) {
      if (line[i] != '\r') plain += line[i];
      continue;
    }
    i = line.find_first_not_of("0123456789;", i + 2);
    if (i == std::string::npos) break;
  }
  return plain;
}

void RunLog::take(const std::string& line) {
  constexpr std::size_t kMostLines = 300;
  const auto group = groupIn(line);
  if (group && group->count("scenes_done") != 0) {
    scenes_done = static_cast<std::int64_t>(numberIn(*group, "scenes_done"));
    scenes = static_cast<std::int64_t>(numberIn(*group, "scenes"));
    rate = numberIn(*group, "rate");
    time_left = numberIn(*group, "time_left");
  } else if (group && group->count("result") != 0) {
    result = group->at("result").text();
    errors = textsIn(*group, "errors");
  } else {
    lines.push_back(base::printable(withoutColours(line)));
    if (lines.size() > kMostLines) lines.pop_front();
  }
}

}  // namespace synthetic_dataset::programs

#include "programs/setup_assistant/catalogue/catalogue.h"

#include <cctype>
#include <exception>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "output/writers/writer_host.h"
#include "plugins/readback/format.h"
#include "programs/embedded/embedded_files.h"
#include "programs/settings/documented_settings.h"

namespace synthetic_dataset::programs {
namespace {

/// The parts between marks: the cells of a table's line, or the words in backquotes of a text.
std::vector<std::string> partsOf(const std::string& text, char mark) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, mark);) {
    const std::size_t begin = part.find_first_not_of(' ');
    const std::size_t end = part.find_last_not_of(' ');
    parts.push_back(begin == std::string::npos ? "" : part.substr(begin, end + 1 - begin));
  }
  return parts;
}

/// The name by which links refer to a heading: lower case, with dashes for spaces.
std::string anchorOf(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (c == ' ' || c == '-' || c == '_') {
      anchor += c == ' ' ? '-' : c;
    }
  }
  return anchor;
}

using Table = std::vector<std::vector<std::string>>;  ///< the cells of each line

/// The tables of each section, by its anchor, with an empty line between two tables; those before
/// the first heading by "".
std::map<std::string, Table> tablesOf(const std::string& document) {
  std::map<std::string, Table> tables;
  std::istringstream stream(document);
  std::string section;
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("## ", 0) == 0) section = anchorOf(line.substr(3));
    const bool is_row = !line.empty() && line.front() == '|';
    tables[section].push_back(is_row ? partsOf(line.substr(1), '|') : Table::value_type());
  }
  return tables;
}

/// The settings in the tables that begin with the word "setting", and others that are declared.
Value::List optionsIn(const Table& lines, const std::string& format,
                      std::map<std::string, Value::Map> declared) {
  Value::List options;
  const auto add = [&](const std::string& name, const std::string& text, Value::Map option) {
    option["name"] = name;
    option["text"] = text;
    options.emplace_back(std::move(option));
  };
  bool is_settings = false;
  for (const std::vector<std::string>& cells : lines) {
    is_settings = cells.size() > 1 && (is_settings || cells.front() == "setting");
    if (!is_settings) continue;
    const std::vector<std::string> names = partsOf(cells[0], '`');
    for (std::size_t i = 1; i < names.size(); i += 2) {
      const std::string full_name = format + "/" + names[i];
      add(names[i], cells[1], std::move(declared[full_name]));
      declared.erase(full_name);
    }
  }
  const std::string start = format + "/";
  for (auto& [name, option] : declared) {
    if (name.rfind(start, 0) == 0) add(name.substr(start.size()), "", std::move(option));
  }
  return options;
}

/// What the writers of all formats declare about their settings.
std::map<std::string, Value::Map> declaredByWriters() {
  Parameters settings(Value::Map{});
  std::vector<output::WriterOptions> writers;
  for (const auto& [name, type] : formats::formatNames()) {
    writers.push_back({name, type, "/", settings.group(name)});
  }
  DatasetInfo dataset;
  dataset.cameras.push_back(
      {"camera", "camera", CameraModel(2, 2, {1.0, 1.0, 0.5, 0.5}, 0.1, 1.0)});
  dataset.motions.emplace_back();
  try {
    const output::WriterHost host(writers, dataset);
  } catch (const std::exception&) {  // some need more than this, but have read their settings
  }
  return settings.declarations();
}

}  // namespace

Value parameterList() {
  std::map<std::string, Value::Map> declared = declaredSettings();
  Value::List parameters;
  for (const DocumentedSetting& each : documentedSettings()) {
    Value::Map parameter = std::move(declared[each.path]);
    if (each.is_active && !each.isRequired()) parameter.emplace("default", each.value);
    if (!each.unit.empty()) parameter["unit"] = each.unit;
    parameter["path"] = each.path;
    parameter["text"] = each.description;
    parameter["required"] = each.isRequired();
    parameters.emplace_back(std::move(parameter));
  }
  return Value::Map{{"parameters", Value(parameters)}};
}

Value formatList() {
  auto tables = tablesOf(EmbeddedFiles().find("formats.md").value());
  const std::map<std::string, Value::Map> declared = declaredByWriters();
  Value::List list;
  for (const auto& [name, type] : formats::formatNames()) {
    const std::string link = "[`" + type + "`](#";
    for (const std::vector<std::string>& cells : tables[""]) {
      if (cells.size() < 3 || cells[0].rfind(link, 0) != 0) continue;
      const std::string anchor = cells[0].substr(link.size(), cells[0].size() - link.size() - 1);
      list.push_back(Value::Map{{"name", Value(name)},
                                {"type", Value(type)},
                                {"text", Value(cells[1])},
                                {"read_by", Value(cells[2])},
                                {"options", Value(optionsIn(tables[anchor], name, declared))}});
      break;  // out of the loop over `tables`, which may have grown
    }
  }
  return Value::Map{{"formats", Value(list)}};
}

}  // namespace synthetic_dataset::programs

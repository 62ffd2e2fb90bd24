#pragma once

#include <cstddef>
#include <string>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::base {

/// A file's layout, for text that is added to it.
struct YamlLayout {
  std::string line_break = "\n";
  std::size_t indentation = 2;       ///< of a group within a group
  std::size_t list_indentation = 2;  ///< of a list's dashes below its name
};

/// A value on one line. Texts are quoted if necessary; deg(30) and rad(pi) are not, as they are
/// angles.
/// @param in_flow  within brackets, where more texts need quotes
[[nodiscard]] std::string flowYaml(const Value& value, bool in_flow);

/// A scalar that replaces another one, in the same quotes if possible.
[[nodiscard]] std::string scalarLike(const Value& value, const std::string& earlier, bool in_flow);

/// A name in a map.
[[nodiscard]] std::string nameYaml(const std::string& name, bool in_flow);

/// Whether a value reads best on lines of its own: groups, lists of groups or lists, and lists too
/// long for one line.
/// @param column  where it would begin on one line
[[nodiscard]] bool wantsLines(const Value& value, std::size_t column);

/// A list or map, not empty, with one or more lines per entry. The first line lacks its
/// indentation, the last one its line break.
[[nodiscard]] std::string blockYaml(const Value& value, std::size_t column,
                                    const YamlLayout& layout);

/// A name, its colon, and its value after or below it.
[[nodiscard]] std::string entryYaml(const std::string& name, const Value& value, std::size_t column,
                                    const YamlLayout& layout);

/// A list entry after its dash.
[[nodiscard]] std::string dashYaml(const Value& value, std::size_t column,
                                   const YamlLayout& layout);

/// Whether a text means an angle in settings, such as deg(30).
[[nodiscard]] bool isAngleText(const std::string& text);

}  // namespace synthetic_dataset::base

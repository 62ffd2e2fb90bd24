#pragma once

#include <cstddef>
#include <string>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::base {

/// How a file is laid out, for what is added to it.
struct YamlLayout {
  std::string line_break = "\n";
  std::size_t indentation = 2;       ///< of a group within a group
  std::size_t list_indentation = 2;  ///< of a list's dashes below its name
};

/// A value in one line. Texts are in quotes where they have to be; deg(30) and rad(pi) are not:
/// they are angles.
/// @param in_flow  within brackets, where more texts need quotes
[[nodiscard]] std::string flowYaml(const Value& value, bool in_flow);

/// The same of a scalar that replaces another one, in the same quotes if it may be.
[[nodiscard]] std::string scalarLike(const Value& value, const std::string& earlier, bool in_flow);

/// A name in a map.
[[nodiscard]] std::string nameYaml(const std::string& name, bool in_flow);

/// Whether a value reads best in lines of its own: groups, and lists of groups or lists.
/// @param column  where it would begin in one line
[[nodiscard]] bool wantsLines(const Value& value, std::size_t column);

/// A list or map, not empty, an entry a line or more. The first line is without its indentation,
/// the last one without its break.
[[nodiscard]] std::string blockYaml(const Value& value, std::size_t column,
                                    const YamlLayout& layout);

/// A name, its colon, and its value behind or below it.
[[nodiscard]] std::string entryYaml(const std::string& name, const Value& value, std::size_t column,
                                    const YamlLayout& layout);

/// A dash and the entry of a list.
[[nodiscard]] std::string dashYaml(const Value& value, std::size_t column,
                                   const YamlLayout& layout);

/// Whether a text stands for an angle in settings: deg(30).
[[nodiscard]] bool isAngleText(const std::string& text);

}  // namespace synthetic_dataset::base

#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace synthetic_dataset::base {

struct YamlEntry;

/// A value in a YAML text and its place there: the bytes from `begin` up to, but excluding, `end`.
/// Comments around it do not belong to it; those between the entries of a list or map do.
struct YamlPart {
  enum class Kind { kNothing, kScalar, kList, kMap, kAlias };

  Kind kind = Kind::kNothing;
  bool is_flow = false;     ///< a list or map in brackets
  std::size_t begin = 0;    ///< of its anchor and tag, if it has any
  std::size_t content = 0;  ///< after these
  std::size_t end = 0;
  std::size_t anchor = 0;  ///< number of its anchor, or of the one that an alias refers to; 0: none
  std::vector<YamlEntry> entries;  ///< of a list or map, in the order of the text
};

/// An entry of a list or map.
struct YamlEntry {
  std::string name;           ///< in a map
  std::size_t begin = 0;      ///< of the name, or of the dash
  std::size_t indicator = 0;  ///< just after the colon or the dash
  YamlPart value;
};

/// Finds where everything is in the first document of a YAML text.
/// @param origin  for messages
/// @throws Error if it is not YAML, or has a layout that is not supported
[[nodiscard]] YamlPart outlineYaml(const std::string& text, const std::string& origin);

}  // namespace synthetic_dataset::base

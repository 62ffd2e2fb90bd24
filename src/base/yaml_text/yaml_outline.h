#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace synthetic_dataset::base {

struct YamlEntry;

/// A value of a YAML text, and where in the text it is: bytes from `begin` until before `end`.
/// Comments around it are not of it; those between the entries of a list or map are.
struct YamlPart {
  enum class Kind { kNothing, kScalar, kList, kMap, kAlias };

  Kind kind = Kind::kNothing;
  bool is_flow = false;     ///< a list or map in brackets
  std::size_t begin = 0;    ///< of its anchor and tag, if it has any
  std::size_t content = 0;  ///< behind these
  std::size_t end = 0;
  std::size_t anchor = 0;  ///< number of its anchor, or of the one an alias stands for; 0: none
  std::vector<YamlEntry> entries;  ///< of a list or map, in the text's order
};

/// An entry of a list or map.
struct YamlEntry {
  std::string name;           ///< in a map
  std::size_t begin = 0;      ///< of the name, or of the dash
  std::size_t indicator = 0;  ///< just behind the colon or the dash
  YamlPart value;
};

/// Where all is in a YAML text's first document.
/// @param origin  for messages
/// @throws Error when it is not YAML, or laid out as this cannot follow
[[nodiscard]] YamlPart outlineYaml(const std::string& text, const std::string& origin);

}  // namespace synthetic_dataset::base

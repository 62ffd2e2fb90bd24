#pragma once

#include <string>

namespace synthetic_dataset::world {

/// Repairs the text of a file for a stricter parser. Gazebo Classic reads XML with TinyXML 1, which
/// also accepts attributes without quotes and a declaration that is not at the very beginning. Line
/// numbers are preserved.
[[nodiscard]] std::string repairedXml(const std::string& text);

}  // namespace synthetic_dataset::world

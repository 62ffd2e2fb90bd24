#pragma once

#include <string>

namespace synthetic_dataset::world {

/// The text of a file as a stricter parser takes it. Gazebo Classic reads XML with TinyXML 1, which
/// also accepts attributes without quotes and a declaration that is not at the very beginning.
/// Lines keep their numbers.
[[nodiscard]] std::string repairedXml(const std::string& text);

}  // namespace synthetic_dataset::world

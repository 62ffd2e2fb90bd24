#pragma once

#include <cstddef>
#include <string>

namespace synthetic_dataset::render {

/// What is painted is encoded, and exposed later (shown.glsl).
inline constexpr const char* kEncodedMacro = "#define ENCODED\n";

/// A shader's source with lines after its first one, where GLSL wants its #version.
[[nodiscard]] inline std::string withMacros(const std::string& source, const std::string& macros) {
  const std::size_t first_line = source.find('\n') + 1;
  return source.substr(0, first_line) + macros + source.substr(first_line);
}

}  // namespace synthetic_dataset::render

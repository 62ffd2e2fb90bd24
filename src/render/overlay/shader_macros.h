#pragma once

#include <cstddef>
#include <string>

namespace synthetic_dataset::render {

/// With it, what is painted is encoded, and exposed later (shown.glsl).
inline constexpr const char* kEncodedMacro = "#define ENCODED\n";

/// Inserts lines after the first one of a shader's source, which GLSL requires to be #version.
[[nodiscard]] inline std::string withMacros(const std::string& source, const std::string& macros) {
  const std::size_t first_line = source.find('\n') + 1;
  return source.substr(0, first_line) + macros + source.substr(first_line);
}

}  // namespace synthetic_dataset::render

#pragma once

#include <cstddef>
#include <string_view>

/// One limit for everything that nests in files: recursive functions read it, and unlimited nesting
/// would overflow the stack. tinyxml2 and newer releases of yaml-cpp have limits of their own, of
/// 500, with less helpful messages. Header-only, as plugins use it, too.
namespace synthetic_dataset::base {

inline constexpr int kDeepestNesting = 400;

/// The message about a text that nests deeper.
inline constexpr const char* kNestedTooDeep = "nested deeper than 400 levels";

/// Whether a JSON text nests too deep, counting brackets outside strings.
[[nodiscard]] inline bool isDeepJson(std::string_view text) {
  int depth = 0;
  bool is_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') {
      is_string = !is_string;
    } else if (is_string) {
      i += c == '\\' ? 1 : 0;
    } else if (c == '[' || c == '{') {
      if (++depth > kDeepestNesting) return true;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return false;
}

}  // namespace synthetic_dataset::base

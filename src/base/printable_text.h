#pragma once

#include <string>
#include <string_view>

namespace synthetic_dataset::base {

/// UTF-8 as it is, and bytes that are none as `\xe4`.
[[nodiscard]] std::string asUtf8(std::string_view text);

/// A text for a terminal or a log, which may come from anybody's file: as asUtf8, and control
/// characters but tabs and line ends as `\x1b`, since terminals take them for commands.
[[nodiscard]] std::string printable(std::string_view text);

/// Has libraries that print texts take them for UTF-8, whatever the locale. Nothing else changes:
/// numbers, dates and messages of the system are those of the C locale.
void printUtf8();

}  // namespace synthetic_dataset::base

#pragma once

#include <string>
#include <string_view>

namespace synthetic_dataset::base {

/// Keeps UTF-8 and escapes all other bytes, as in `\xe4`.
[[nodiscard]] std::string asUtf8(std::string_view text);

/// A text, possibly from an untrusted file, for a terminal or a log: as asUtf8, and with control
/// characters other than tabs and line ends escaped, as in `\x1b`, since terminals take them for
/// commands.
[[nodiscard]] std::string printable(std::string_view text);

/// Makes libraries that print texts treat them as UTF-8, whatever the locale. Nothing else changes:
/// numbers, dates and system messages are those of the C locale.
void printUtf8();

}  // namespace synthetic_dataset::base

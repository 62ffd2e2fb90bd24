#pragma once

#include <string>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::base {

/// A value as JSON that parseYaml reads back; numbers that JSON has no words for (`.inf`, `.nan`)
/// as YAML has them.
[[nodiscard]] std::string jsonText(const Value& value);

/// The same for programs that take JSON alone: such numbers are texts (".inf"), and bytes that are
/// no UTF-8 are U+FFFD. In one line.
[[nodiscard]] std::string strictJsonText(const Value& value);

/// Reads JSON (RFC 8259). The texts ".inf", "-.inf" and ".nan" are numbers, as strictJsonText
/// writes them.
/// @param origin  for messages
/// @throws Error when it is none, or nests too deep
[[nodiscard]] Value parseJson(const std::string& text, const std::string& origin);

}  // namespace synthetic_dataset::base

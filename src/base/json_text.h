#pragma once

#include <string>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::base {

/// A value as JSON that parseYaml reads back; numbers that JSON cannot express are written as in
/// YAML (`.inf`, `.nan`).
[[nodiscard]] std::string jsonText(const Value& value);

/// A value as strict JSON, in one line: numbers that JSON cannot express are texts (".inf"), and
/// bytes that are not UTF-8 are written as asUtf8() does.
[[nodiscard]] std::string strictJsonText(const Value& value);

/// Reads JSON (RFC 8259). The texts ".inf", "-.inf" and ".nan" are numbers, as strictJsonText
/// writes them.
/// @param origin  for messages
/// @throws Error if it is not JSON, or nested too deep
[[nodiscard]] Value parseJson(const std::string& text, const std::string& origin);

}  // namespace synthetic_dataset::base

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

}  // namespace synthetic_dataset::base

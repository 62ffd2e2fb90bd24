#pragma once

#include <string>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::base {

/// Reads JSON (RFC 8259). The texts ".inf", "-.inf" and ".nan" are numbers, as strictJsonText
/// writes them.
/// @param origin  for messages
/// @throws Error when it is none
[[nodiscard]] Value parseJson(const std::string& text, const std::string& origin);

}  // namespace synthetic_dataset::base

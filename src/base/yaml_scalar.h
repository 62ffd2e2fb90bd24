#pragma once

#include <optional>
#include <string>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::base {

/// The value that PyYAML gives to a text without quotes (its yaml/resolver.py and
/// yaml/constructor.py, YAML 1.1): yes is true, 010 is 8, 1:30 is 90, 1e5 is a text since a float
/// needs its decimal point.
[[nodiscard]] Value plainScalar(const std::string& text);

[[nodiscard]] std::optional<bool> asBool(const std::string& text);
[[nodiscard]] std::optional<std::int64_t> asInteger(const std::string& text);
[[nodiscard]] std::optional<double> asFloat(const std::string& text);

/// Whether PyYAML reads the text as a date, or a date and a time.
[[nodiscard]] bool isTimestamp(const std::string& text);

/// A decimal number, with or without point and exponent, whatever the locale; nullopt if the text
/// contains anything else.
[[nodiscard]] std::optional<double> decimalNumber(const std::string& text);

}  // namespace synthetic_dataset::base

#pragma once

#include <string>

namespace synthetic_dataset::formats {

/// What a text is when it has been written to JSON and read again: bytes that are not UTF-8 are
/// U+FFFD then.
[[nodiscard]] std::string asJsonHasIt(const std::string& text);

/// The text as JSON, with its quotes.
[[nodiscard]] std::string quotedInJson(const std::string& text);

}  // namespace synthetic_dataset::formats

#pragma once

#include <cstdint>
#include <string>

namespace synthetic_dataset {
inline namespace v2 {

/// A number with a fixed count of decimals, whatever the locale: `fixed(2.5, 5)` is "2.50000".
[[nodiscard]] std::string fixed(double number, int decimals);

/// A scene's index as file names have it: eight digits with leading zeros, "00000012".
[[nodiscard]] std::string sceneNumber(std::int64_t index);

/// A file or folder name made of any text, such as an object's name. Letters, digits, `-`, `_`, `.`
/// and all that is not ASCII stay; what else there is becomes `_`, and long names end early. A name
/// that was changed ends in a hash of the text, so that different texts keep different names.
[[nodiscard]] std::string safeFileName(const std::string& text);

}  // namespace v2
}  // namespace synthetic_dataset

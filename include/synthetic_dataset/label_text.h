#pragma once

#include <cstdint>
#include <string>

namespace synthetic_dataset {
inline namespace v2 {

/// A number with a fixed number of decimals in any locale: `fixed(2.5, 5)` is "2.50000".
[[nodiscard]] std::string fixed(double number, int decimals);

/// A scene's index as used in file names: eight digits with leading zeros, "00000012".
[[nodiscard]] std::string sceneNumber(std::int64_t index);

/// Turns any text, such as an object's name, into a file or folder name. Letters, digits, `-`, `_`,
/// `.` and all non-ASCII characters stay; all others become `_`, and long names are cut. A name
/// that was changed ends in a hash of the text, so that different texts keep different names.
[[nodiscard]] std::string safeFileName(const std::string& text);

}  // namespace v2
}  // namespace synthetic_dataset

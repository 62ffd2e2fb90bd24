#pragma once

#include <cstdint>
#include <string>

namespace synthetic_dataset {
inline namespace v1 {

/// A number with a fixed count of decimals, whatever the locale: `fixed(2.5, 5)` is "2.50000".
[[nodiscard]] std::string fixed(double number, int decimals);

/// A scene's index as file names have it: eight digits with leading zeros, "00000012".
[[nodiscard]] std::string sceneNumber(std::int64_t index);

}  // namespace v1
}  // namespace synthetic_dataset

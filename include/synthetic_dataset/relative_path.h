#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace synthetic_dataset {
inline namespace v2 {

/// Why a writer cannot use this path for a file in its folder; nullopt if it can.
/// A valid path is relative and normalised, stays in the folder and suits every Linux file system.
[[nodiscard]] std::optional<std::string> relativePathProblem(std::string_view path);

}  // namespace v2
}  // namespace synthetic_dataset

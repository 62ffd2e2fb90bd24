#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace synthetic_dataset {
inline namespace v2 {

/// Why a writer's path of a file in its folder cannot be used; nothing when it can.
/// A good one is relative, normalised, stays in the folder and fits every file system of Linux.
[[nodiscard]] std::optional<std::string> relativePathProblem(std::string_view path);

}  // namespace v2
}  // namespace synthetic_dataset

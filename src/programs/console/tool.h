#pragma once

#include <functional>
#include <string>

namespace synthetic_dataset::programs {

/// Does a tool's work, whose result is its exit code. What it throws is printed to the standard
/// error, "NAME: message" for each of its errors.
/// @return what the work returns; 1 when it throws
[[nodiscard]] int reportingErrors(const std::string& name, const std::function<int()>& work);

}  // namespace synthetic_dataset::programs

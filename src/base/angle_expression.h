#pragma once

#include <string>

namespace synthetic_dataset::base {

/// The value of rosparam's `rad(...)` and `!radians` [rad]: numbers, pi, + - * / ** and
/// parentheses, as Python computes them (rosparam lets Python evaluate the text; functions are not
/// supported here).
/// @throws Error saying what was found
[[nodiscard]] double radians(const std::string& expression);

/// The value of rosparam's `deg(...)` and `!degrees` [rad]: one number, in degrees.
/// @throws Error saying what was found
[[nodiscard]] double degrees(const std::string& number);

}  // namespace synthetic_dataset::base

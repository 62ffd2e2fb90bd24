#pragma once

namespace synthetic_dataset::render::likeness {

// How the pixels around a sample are compared with what it sees, to find the one with its light.
inline constexpr float kAlike = 0.01F;   ///< then its own centre is the nearest there is
inline constexpr float kAway = 0.02F;    ///< what a pixel away counts, against a turn of a radian
inline constexpr float kDepth = 10.0F;   ///< what depth counts: a share of it
inline constexpr float kUnlike = 1e30F;  ///< another surface

}  // namespace synthetic_dataset::render::likeness

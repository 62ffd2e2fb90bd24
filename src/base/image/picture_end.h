#pragma once

#include <cstdint>
#include <vector>

namespace synthetic_dataset::base {

/// Whether a JPEG, TGA, DDS, BMP, GIF, PSD, Radiance or OpenEXR file has all the bytes of its
/// (first) picture.
/// Decoders fill what is missing of one that breaks off with grey, or with whatever the memory
/// holds.
/// @return true for files of other formats, whose decoders refuse them
[[nodiscard]] bool isWhole(const std::vector<std::uint8_t>& file);

}  // namespace synthetic_dataset::base

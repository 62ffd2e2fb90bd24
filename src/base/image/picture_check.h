#pragma once

#include <cstdint>
#include <vector>

namespace synthetic_dataset::base {

/// Whether a JPEG, TGA, DDS, BMP, GIF, PSD, Radiance or OpenEXR file has all the bytes of its
/// (first) picture.
/// Decoders fill what is missing of one that breaks off with grey, or with whatever the memory
/// holds.
/// @return true for files of other formats, whose decoders refuse them
[[nodiscard]] bool isWhole(const std::vector<std::uint8_t>& bytes);

/// A PNG file reduced to the chunks that make its pixels (PNG specification, third edition, section
/// 11: IHDR, PLTE, tRNS, IDAT, IEND). The decoder prints complaints about the others, colour
/// profiles above all, which do not change what OpenCV reads. Other files stay as they are.
/// @return nothing for a PNG file that breaks off or whose checksums are wrong
[[nodiscard]] std::vector<std::uint8_t> withoutColourProfile(const std::vector<std::uint8_t>& file);

}  // namespace synthetic_dataset::base

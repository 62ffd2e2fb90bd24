#pragma once

#include <cstdint>
#include <vector>

namespace synthetic_dataset::base {

/// Whether a JPEG, TGA, DDS, BMP, GIF, PSD, Radiance or OpenEXR file has all the bytes of its
/// (first) picture. Decoders fill what a truncated file lacks with grey, or with whatever the
/// memory holds.
/// @return true for files of other formats, whose decoders reject truncated files
[[nodiscard]] bool isWhole(const std::vector<std::uint8_t>& bytes);

/// Reduces a PNG file to the chunks that define its pixels (PNG specification, third edition,
/// section 11: IHDR, PLTE, tRNS, IDAT, IEND). The decoder prints complaints about the others,
/// mostly colour profiles, which do not change what OpenCV reads. Other files stay as they are.
/// @return empty for a PNG file that is truncated or has wrong checksums
[[nodiscard]] std::vector<std::uint8_t> essentialPngChunks(const std::vector<std::uint8_t>& file);

}  // namespace synthetic_dataset::base

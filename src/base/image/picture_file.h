#pragma once

#include <cstdint>
#include <vector>

namespace synthetic_dataset::base {

/// A PNG file reduced to the chunks that make its pixels (PNG specification, third edition, section
/// 11: IHDR, PLTE, tRNS, IDAT, IEND). The decoder prints complaints about the others, colour
/// profiles above all, which do not change what OpenCV reads. Other files stay as they are.
/// @return nothing for a PNG file that breaks off or whose checksums are wrong
[[nodiscard]] std::vector<std::uint8_t> withoutColourProfile(const std::vector<std::uint8_t>& file);

}  // namespace synthetic_dataset::base

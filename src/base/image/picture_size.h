#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace synthetic_dataset::base {

struct PictureSize {
  std::uint64_t width = 0;  ///< [pixel]
  std::uint64_t height = 0;
};

/// The size that a picture file's header claims, without decoding anything: for PNG, JPEG, BMP,
/// GIF, WebP, TIFF, DDS, PSD, Radiance and OpenEXR files and, tried last as it has no magic number,
/// TGA.
/// @return nullopt for a file that is none of these, or too short
[[nodiscard]] std::optional<PictureSize> claimedSize(const std::vector<std::uint8_t>& file);

}  // namespace synthetic_dataset::base

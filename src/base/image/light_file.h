#pragma once

#include <optional>

#include "base/image/picture_bytes.h"
#include "base/image/picture_size.h"

/// Files of linear light, which may be brighter than white: Radiance's (.hdr; Ward 1991, "Real
/// Pixels") and OpenEXR's (.exr; "OpenEXR File Layout").
namespace synthetic_dataset::base {

[[nodiscard]] bool isLight(const PictureBytes& file);

/// The size that the header claims, as in claimedSize().
[[nodiscard]] std::optional<PictureSize> lightSize(const PictureBytes& file);

/// Whether all the picture's bytes are present, as in isWhole().
[[nodiscard]] bool isWholeLight(const PictureBytes& file);

}  // namespace synthetic_dataset::base

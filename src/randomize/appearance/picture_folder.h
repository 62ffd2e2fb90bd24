#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/image/picture_size.h"
#include "randomize/appearance/recent_textures.h"
#include "world/description.h"

namespace synthetic_dataset::randomize {

/// Which of a folder's files are pictures.
enum class PictureKind {
  kEncoded,  ///< those that end in png, jpg, jpeg, bmp, tif, tiff or webp
  kAny,      ///< also those of linear light, which may be brighter than white: hdr or exr
};

/// The pictures in a folder and in those below it, in alphabetical order.
/// @throws Error for a folder that is not there or has no picture
[[nodiscard]] std::vector<std::string> picturesIn(const std::string& folder, PictureKind kind);

/// A folder's pictures, whose files are looked at once, before any is needed: their headers, and
/// whether they break off. A damage that only decoding brings to light is found when it is decoded.
class PictureFolder {
 public:
  /// @throws Error for a folder that is not there or has no picture
  /// @throws ErrorList naming pictures that cannot be decoded
  PictureFolder(const std::string& folder, PictureKind kind);

  [[nodiscard]] const std::vector<std::string>& files() const { return files_; }

  /// The size of each of files() [px].
  [[nodiscard]] const std::vector<base::PictureSize>& sizes() const { return sizes_; }

  /// A picture, opaque.
  /// @param index  in files()
  /// @throws Error for one that cannot be decoded
  [[nodiscard]] std::shared_ptr<const world::Texture> read(std::size_t index);

 private:
  std::vector<std::string> files_;
  std::vector<base::PictureSize> sizes_;
  RecentTextures recent_;
};

}  // namespace synthetic_dataset::randomize

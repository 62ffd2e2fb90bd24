#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/image/picture_size.h"
#include "randomize/appearance/recent_textures.h"
#include "world/description.h"

namespace synthetic_dataset::randomize {

/// Which of a folder's files count as pictures.
enum class PictureKind {
  kEncoded,  ///< those with the extension png, jpg, jpeg, bmp, tif, tiff or webp
  kAny,      ///< also those in linear light, which may be brighter than white: hdr or exr
};

/// The pictures in a folder and its subfolders, in alphabetical order.
/// @throws Error if the folder does not exist or has no pictures
[[nodiscard]] std::vector<std::string> picturesIn(const std::string& folder, PictureKind kind);

/// A folder's pictures. Their files are checked once, before any is needed: the headers, and
/// whether the files are truncated. Other damage only shows when a picture is decoded.
class PictureFolder {
 public:
  /// @throws Error if the folder does not exist or has no pictures
  /// @throws ErrorList naming pictures that cannot be decoded
  PictureFolder(const std::string& folder, PictureKind kind);

  [[nodiscard]] const std::vector<std::string>& files() const { return files_; }

  /// The size of each of files() [px].
  [[nodiscard]] const std::vector<base::PictureSize>& sizes() const { return sizes_; }

  /// A picture, made opaque.
  /// @param index  in files()
  /// @throws Error if it cannot be decoded
  [[nodiscard]] std::shared_ptr<const world::Texture> read(std::size_t index);

 private:
  std::vector<std::string> files_;
  std::vector<base::PictureSize> sizes_;
  RecentTextures recent_;
};

}  // namespace synthetic_dataset::randomize

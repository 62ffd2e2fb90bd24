#pragma once

#include <string_view>
#include <vector>

#include "base/image/image_encoder.h"
#include "output/dataset_store.h"

namespace synthetic_dataset::output {

/// The bytes of one or, for pixels that are asked for more than once, several files of a scene.
struct SceneContent {
  std::vector<uchar> encoded;      ///< of an image
  std::string_view text;           ///< of a text file; lives as long as the scene's files
  std::vector<std::size_t> files;  ///< indices of the files that have it, at least one

  [[nodiscard]] std::string_view bytes() const;
};

/// What the files of a scene hold, in the order of their first mention: of those that hold the same
/// image in the same format, once.
/// @param recorded  a picture whose JPEG files have its bytes
/// @throws Error naming the file whose image cannot be encoded
[[nodiscard]] std::vector<SceneContent> encodeScene(const std::vector<OutputFile>& files,
                                                    const base::ImageQuality& quality,
                                                    const RecordedJpeg& recorded = {});

}  // namespace synthetic_dataset::output

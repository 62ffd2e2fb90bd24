#pragma once

#include <string_view>
#include <vector>

#include "base/image/image_encoder.h"
#include "output/dataset_store.h"

namespace synthetic_dataset::output {

/// The bytes of one file of a scene, or of several if the same pixels were requested repeatedly.
struct SceneContent {
  std::vector<uchar> encoded;      ///< for an image
  std::string_view text;           ///< for a text file; valid as long as the scene's files are
  std::vector<std::size_t> files;  ///< indices of the files with this content, at least one

  [[nodiscard]] std::string_view bytes() const;
};

/// The contents of a scene's files in order of first use; the same image in the same format appears
/// once.
/// @param recorded  a picture whose JPEG files reuse its recorded bytes
/// @throws Error naming the file whose image cannot be encoded
[[nodiscard]] std::vector<SceneContent> encodeScene(const std::vector<OutputFile>& files,
                                                    const base::ImageQuality& quality,
                                                    const RecordedJpeg& recorded = {});

}  // namespace synthetic_dataset::output

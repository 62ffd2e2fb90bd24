#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/mask.h"

namespace synthetic_dataset::output {

/// A writer as the store knows it.
struct StoreWriter {
  std::string name;
  std::string type;
  std::string output_folder;            ///< absolute, ending in `/`
  std::vector<std::string> user_files;  ///< absolute paths of files that it makes elsewhere
};

/// A file to be made for one scene or for the dataset: pixels, a mask or text.
struct OutputFile {
  std::size_t writer = 0;  ///< index in the store's writers
  std::string path;        ///< absolute
  cv::Mat pixels;          ///< empty for a mask or a text file
  std::string text;
  std::vector<cv::Vec3b> palette = {};  ///< if not empty, the pixels are indices into it
  Mask mask = {};                       ///< has an empty image size unless the file is a mask
};

/// A picture from a JPEG file: if it is to be stored as a JPEG again, the original bytes are used.
struct RecordedJpeg {
  cv::Mat pixels;
  std::vector<std::uint8_t> bytes;  ///< empty if it did not come from a JPEG file
};

/// Everything that the writers want to store for one scene.
struct SceneFiles {
  struct Record {
    std::size_t writer = 0;  ///< index in the store's writers
    std::string channel;     ///< which of the writer's records it belongs to; without newlines
    std::string text;
  };
  std::vector<OutputFile> files;
  std::vector<Record> records;
  RecordedJpeg recorded = {};
};

/// What a dataset holds so far.
struct StoreCounts {
  std::int64_t scenes = 0;
  std::int64_t files = 0;
  std::int64_t bytes = 0;  ///< linked files count once
};

/// The number of scenes in which an object was found.
struct ObjectCounts {
  std::int64_t in_view = 0;  ///< judged by its loose box
  std::int64_t seen = 0;     ///< with a visible pixel, where visible pixels were counted
  std::int64_t dropped = 0;  ///< in view, but below the thresholds
  std::int64_t counted = 0;  ///< scenes in which its visible pixels were counted

  /// Scenes in which it should have a label: seen (or in view, if its pixels were not counted) and
  /// not dropped.
  std::int64_t labelled = 0;

  std::int64_t compared = 0;         ///< scenes with a background-subtraction mask and an exact one
  double mean_mask_agreement = 0.0;  ///< mean intersection over union of the two, 0 .. 1
};

/// What one split of a dataset holds.
struct SplitCounts {
  std::string name;
  std::int64_t scenes = 0;
  std::int64_t labelled = 0;  ///< scenes in which an object should have a label
};

}  // namespace synthetic_dataset::output

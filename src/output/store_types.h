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
  std::vector<std::string> user_files;  ///< absolute paths of files that it makes anywhere else
};

/// A file that one scene or the dataset gets: pixels, a mask or text.
struct OutputFile {
  std::size_t writer = 0;  ///< index in the store's writers
  std::string path;        ///< absolute
  cv::Mat pixels;          ///< empty for a mask or a text file
  std::string text;
  std::vector<cv::Vec3b> palette = {};  ///< not empty: the pixels are indices of it
  Mask mask = {};                       ///< of no image unless the file is one of it
};

/// A picture that was a JPEG file before: where it is to be one again, it is that file.
struct RecordedJpeg {
  cv::Mat pixels;
  std::vector<std::uint8_t> bytes;  ///< empty: it was none
};

/// All that the writers want for one scene.
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
  std::int64_t bytes = 0;  ///< a linked file counts once
};

/// In how many scenes an object was found.
struct ObjectCounts {
  std::int64_t in_view = 0;  ///< by its loose box
  std::int64_t seen = 0;     ///< with a visible pixel, where these were counted
  std::int64_t dropped = 0;  ///< of those in view: below the thresholds
  std::int64_t counted = 0;  ///< in which its visible pixels were counted

  /// In which it should have a label: seen, or where that was not counted in view, and not dropped.
  std::int64_t labelled = 0;

  std::int64_t compared = 0;         ///< with a mask by background subtraction and an exact one
  double mean_mask_agreement = 0.0;  ///< intersection over union of these, 0 .. 1
};

/// What a part of a split dataset holds.
struct SplitCounts {
  std::string name;
  std::int64_t scenes = 0;
  std::int64_t labelled = 0;  ///< scenes in which an object should have a label
};

}  // namespace synthetic_dataset::output

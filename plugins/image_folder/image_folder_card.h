#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// What a dataset card says of a dataset, to people and to Hugging Face's loader.
struct DatasetCard {
  std::vector<ClassInfo> classes;
  std::vector<SplitInfo> splits;        ///< that have images
  std::vector<std::string> extensions;  ///< of its pictures
  std::vector<CreditInfo> credits;

  /// Of all images and labels. Hugging Face's loader keeps what it has read of a folder by the
  /// folder's name and its card's header: another content has to have another header.
  std::string fingerprint;

  bool webdataset = false;  ///< whether there is a JSON file beside each image
};

/// Writes README.md: a YAML header for the loader (https://huggingface.co/docs/hub/datasets-cards)
/// and a text about what the columns hold.
void writeCard(std::ostream& file, const DatasetCard& card);

}  // namespace synthetic_dataset

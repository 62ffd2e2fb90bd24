#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// The content of a dataset card, for people and for Hugging Face's loader.
struct DatasetCard {
  std::vector<ClassInfo> classes;
  std::vector<SplitInfo> splits;        ///< splits that have images
  std::vector<std::string> extensions;  ///< of its pictures
  std::vector<CreditInfo> credits;

  /// Fingerprint of all images and labels. Hugging Face's loader caches a folder by its name and
  /// its card's header, so different content needs a different header.
  std::string fingerprint;

  bool webdataset = false;  ///< whether there is a JSON file beside each image
};

/// Writes README.md: a YAML header for the loader (https://huggingface.co/docs/hub/datasets-cards)
/// and a text that explains the columns.
void writeCard(std::ostream& file, const DatasetCard& card);

}  // namespace synthetic_dataset

#pragma once

#include <cstdint>
#include <string>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// The settings of a BOP writer, without those of its models.
struct BopOptions {
  std::string train_folder = "train";
  std::int64_t images_per_scene = 1000;
  double depth_scale = 1.0;  ///< [mm] per unit of a depth image
  bool coco = true;
  std::string image_format = ".png";  ///< including the dot
  std::string train_format = ".png";  ///< of training images

  /// @param split  as Scene::splitFolder()
  [[nodiscard]] const std::string& formatOf(const std::string& split) const {
    return split == "train" ? train_format : image_format;
  }
};

/// Adds errors to `parameters`.
[[nodiscard]] BopOptions readBopOptions(Parameters& parameters, const DatasetInfo& dataset);

}  // namespace synthetic_dataset

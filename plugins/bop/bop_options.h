#pragma once

#include <cstdint>
#include <string>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// The settings of a BOP writer, without those of its models.
struct BopOptions {
  std::string train_folder = "train";
  std::int64_t images_per_scene = 1000;
  double depth_scale = 1.0;  ///< [mm] of a depth image's 1
  bool coco = true;
  std::string image_format = ".png";  ///< with the point
  std::string train_format = ".png";  ///< of images for training

  /// @param split  as Scene::splitFolder()
  [[nodiscard]] const std::string& formatOf(const std::string& split) const {
    return split == "train" ? train_format : image_format;
  }
};

/// Notes errors.
[[nodiscard]] BopOptions readBopOptions(Parameters& parameters, const DatasetInfo& dataset);

}  // namespace synthetic_dataset

#pragma once

#include <vector>

#include "plugins/cityscapes/cityscapes_files.h"
#include "plugins/cityscapes/cityscapes_table.h"

namespace synthetic_dataset {

/// An instance's number is this times its label's, and more; objects of a label that has as many
/// already are a group.
inline constexpr int kCityscapesInstances = 1000;

/// The settings of a Cityscapes writer.
struct CityscapesOptions {
  std::vector<CityscapesLabel> labels;  ///< of each class
  int world_id = 0;                     ///< the label of the world; 0: it is unlabeled
  std::vector<CityscapesLabel> world;   ///< the labels of the world's classes
  CityscapesTable table;                ///< of all labels: Cityscapes' own, or that of the classes
};

[[nodiscard]] CityscapesOptions readCityscapesOptions(
    Parameters& parameters, const std::vector<ClassInfo>& classes,
    const std::vector<std::string>& world_classes);

}  // namespace synthetic_dataset

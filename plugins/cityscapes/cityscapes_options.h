#pragma once

#include <vector>

#include "plugins/cityscapes/cityscapes_files.h"
#include "plugins/cityscapes/cityscapes_table.h"

namespace synthetic_dataset {

/// An instance's number is its label's number times this, plus an index; objects beyond this many
/// per label form a group.
inline constexpr int kCityscapesInstances = 1000;

/// The settings of a Cityscapes writer.
struct CityscapesOptions {
  std::vector<CityscapesLabel> labels;  ///< of each class
  int world_id = 0;                     ///< the label of the world; 0: unlabeled
  std::vector<CityscapesLabel> world;   ///< the labels of the world's classes
  CityscapesTable table;  ///< all labels: Cityscapes' own table, or one of the classes
};

[[nodiscard]] CityscapesOptions readCityscapesOptions(
    Parameters& parameters, const std::vector<ClassInfo>& classes,
    const std::vector<std::string>& world_classes);

}  // namespace synthetic_dataset

#pragma once

#include <map>
#include <string>
#include <vector>

#include "synthetic_dataset/box_choice.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// What KITTI calls regions without labels.
inline constexpr const char* kDontCare = "DontCare";

/// The settings of a KITTI writer.
struct KittiOptions {
  std::map<std::string, std::string> types;  ///< KITTI's, by class
  BoxChoice box = BoxChoice::kVisible;
  bool dont_care = true;  ///< whether objects without a label become such regions
  bool velodyne = false;  ///< whether there are points of a scanner, made of the depth
};

[[nodiscard]] KittiOptions readKittiOptions(Parameters& parameters,
                                            const std::vector<ClassInfo>& classes);

}  // namespace synthetic_dataset

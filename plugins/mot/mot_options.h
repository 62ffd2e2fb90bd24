#pragma once

#include <map>
#include <string>
#include <vector>

#include "synthetic_dataset/box_choice.h"

namespace synthetic_dataset {

inline constexpr int kMotDecimals = 3;  ///< of a box [px] and of a visibility

/// The settings of a MOT writer.
struct MotOptions {
  std::map<int, int> class_ids;    ///< the format's number for each class, from 1
  std::vector<std::string> names;  ///< of the format's classes, from 1
  BoxChoice box = BoxChoice::kVisible;
  std::string image_format = "jpg";
};

[[nodiscard]] MotOptions readMotOptions(Parameters& parameters,
                                        const std::vector<ClassInfo>& classes);

}  // namespace synthetic_dataset

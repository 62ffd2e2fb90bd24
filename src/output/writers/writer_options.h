#pragma once

#include <string>

#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::output {

/// One entry of the parameter `writers`.
struct WriterOptions {
  std::string name;           ///< also the group of its parameters
  std::string type;           ///< pluginlib's lookup name: "synthetic_dataset/Yolo"
  std::string output_folder;  ///< absolute, ending in `/`
  Parameters parameters;      ///< the group `name`
};

}  // namespace synthetic_dataset::output

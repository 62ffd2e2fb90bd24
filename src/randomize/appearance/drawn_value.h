#pragma once

#include <string>
#include <variant>
#include <vector>

namespace synthetic_dataset::randomize {

/// What an entry of `randomize` has drawn in a scene.
struct DrawnValue {
  std::string name;  ///< as the settings have it: "lights/sun/intensity"
  std::variant<std::vector<double>, std::string> value;
};

}  // namespace synthetic_dataset::randomize

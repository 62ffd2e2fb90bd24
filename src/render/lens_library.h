#pragma once

#include <map>
#include <vector>

#include "render/lens_map.h"

namespace synthetic_dataset::render {

/// Makes each camera's LensMap once.
class LensLibrary {
 public:
  /// The reference stays good as long as the library.
  [[nodiscard]] const LensMap& get(const CameraModel& camera);

 private:
  std::map<std::vector<double>, LensMap> maps_;
};

/// The views of a lens's faces.
[[nodiscard]] std::vector<View> faceViews(const LensMap& lens, const View& view);

}  // namespace synthetic_dataset::render

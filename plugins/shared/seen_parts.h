#pragma once

#include <string>
#include <vector>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// What is visible of one of an object's parts.
struct SeenPart {
  std::string name;
  Mask mask;

  /// Around its pixels, from the first one's edge to the last one's.
  [[nodiscard]] Box box() const;
};

/// The parts of an object of which a pixel is visible. Needs `visible_masks` and `part_map`.
/// @param info  the object's
[[nodiscard]] std::vector<SeenPart> seenParts(const Scene& scene, const SceneObject& object,
                                              const ObjectInfo& info);

}  // namespace synthetic_dataset

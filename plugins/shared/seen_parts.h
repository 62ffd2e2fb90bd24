#pragma once

#include <string>
#include <vector>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// The visible portion of one of an object's parts.
struct SeenPart {
  std::string name;
  Mask mask;

  /// The box around its pixels, from the first one's edge to the last one's.
  [[nodiscard]] Box box() const;
};

/// The parts of an object with at least one visible pixel. Needs `visible_masks` and `part_map`.
/// @param info  the object's
[[nodiscard]] std::vector<SeenPart> seenParts(const Scene& scene, const SceneObject& object,
                                              const ObjectInfo& info);

}  // namespace synthetic_dataset

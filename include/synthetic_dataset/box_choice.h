#pragma once

#include <optional>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {
inline namespace v2 {

/// Which 2D box a label has: the parameter `box` of most formats.
enum class BoxChoice {
  kVisible,     ///< around the visible pixels
  kSilhouette,  ///< around the silhouette's pixels, cut to the image
  kLoose,       ///< around the projected bounding shape, cut to the image
};

/// `visible` (the default), `silhouette` or `loose`.
[[nodiscard]] BoxChoice readBoxChoice(Parameters& parameters);

/// What `boxOf` and SceneObject::labelled need.
[[nodiscard]] Requirements requirementsOf(BoxChoice choice);

/// An object's box [px], cut to the image; nothing where no area of it is in the image.
/// @throws Error where what `requirementsOf` names is not required
[[nodiscard]] std::optional<Box> boxOf(const SceneObject& object, BoxChoice choice,
                                       const CameraModel& camera);

}  // namespace v2
}  // namespace synthetic_dataset

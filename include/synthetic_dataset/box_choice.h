#pragma once

#include <optional>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {
inline namespace v2 {

/// The kind of 2D box that a label has: the parameter `box` of most formats.
enum class BoxChoice {
  kVisible,     ///< around the visible pixels
  kSilhouette,  ///< around the silhouette's pixels, cut to the image
  kLoose,       ///< around the projected bounding shape, cut to the image
};

/// Reads the parameter `box`: `visible` (the default), `silhouette` or `loose`.
[[nodiscard]] BoxChoice readBoxChoice(Parameters& parameters);

/// The requirements of `boxOf` and SceneObject::labelled.
[[nodiscard]] Requirements requirementsOf(BoxChoice choice);

/// An object's box [px], cut to the image; nullopt if no area of it is in the image.
/// @throws Error if the run does not require what `requirementsOf` returns
[[nodiscard]] std::optional<Box> boxOf(const SceneObject& object, BoxChoice choice,
                                       const CameraModel& camera);

}  // namespace v2
}  // namespace synthetic_dataset

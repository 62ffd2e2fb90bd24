#pragma once

#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/types.hpp>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

// Settings that several formats have, and what they share besides.

/// A parameter that has to be one of a few texts.
[[nodiscard]] std::string optionalChoice(const Parameters& parameters, const std::string& name,
                                         const std::vector<std::string>& choices,
                                         const std::string& fallback);
[[nodiscard]] std::string requiredChoice(const Parameters& parameters, const std::string& name,
                                         const std::vector<std::string>& choices);

/// Which 2D box a label has: the parameter `box`.
enum class BoxChoice {
  kVisible,     ///< round the visible pixels
  kSilhouette,  ///< the silhouette's, cut to the image
  kLoose,       ///< round the projected bounding shape, cut to the image
};
[[nodiscard]] BoxChoice readBoxChoice(const Parameters& parameters);

/// What has to be known of objects for `boxOf` and SceneObject::labelled.
[[nodiscard]] Requirements requirementsOf(BoxChoice choice);

/// An object's box [px], cut to the image; nothing where no area of it is in the image.
[[nodiscard]] std::optional<Box> boxOf(const SceneObject& object, BoxChoice choice,
                                       const CameraModel& camera);

/// The pixels that the visible box is round, beside which nothing is on the visible mask; empty
/// where no pixel is visible.
[[nodiscard]] cv::Rect visiblePixels(const SceneObject& object);

/// The folder of a scene's split: `train` where the dataset has no splits.
[[nodiscard]] std::string splitOf(const Scene& scene);

/// A scene's name without folders, for formats that hold all images in one: "front_00000012".
[[nodiscard]] std::string flatName(const Scene& scene);

}  // namespace synthetic_dataset

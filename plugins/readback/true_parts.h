#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/box.h"
#include "synthetic_dataset/label_writer.h"

/// What the truth says of classes of the world and of parts of objects. On purpose not by what the
/// writers use (shared/seen_parts.h), which `verify` checks.
namespace synthetic_dataset::formats {

/// What is seen of one of an object's parts.
struct TruePart {
  std::string name;
  Mask mask;

  /// From the first pixel's edge to the last one's.
  [[nodiscard]] Box box() const;
};

/// The parts of an object of which a pixel is visible, in the order of their names.
/// @param dataset  the scene's
[[nodiscard]] std::vector<TruePart> trueParts(const Scene& scene, const SceneObject& object,
                                              const DatasetInfo& dataset);

/// Where no object is seen: CV_8UC1.
[[nodiscard]] cv::Mat trueWorld(const Scene& scene);

/// Where a class of the world is seen.
/// @param number  its index from 1; 0 for what is of none
[[nodiscard]] cv::Mat trueWorldClass(const Scene& scene, std::size_t number);

}  // namespace synthetic_dataset::formats

#pragma once

#include <ostream>
#include <set>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "plugins/shared/colour_map.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// The number of classes, or of objects in one image, that an 8-bit index can distinguish in
/// addition to background and void.
constexpr std::size_t kMostVocIndices = 254;

/// Pascal VOC's segmentation pictures; CV_8UC1. 0 is the background; 255 is void: an object without
/// a label, or a border.
struct VocPictures {
  cv::Mat classes;  ///< index among the classes followed by those of the world, from 1
  cv::Mat objects;  ///< index among the labelled objects, from 1
};

/// @param labelled  objects of the scene; those after the 254th are void in `objects`
/// @param classes  of the dataset, at most 254
/// @param world_classes  number of world classes, whose indices follow
/// @param border  distance to another object or the background within which a pixel is void [px];
///     0: no border
[[nodiscard]] VocPictures vocPictures(const Scene& scene,
                                      const std::vector<const SceneObject*>& labelled,
                                      const std::vector<ClassInfo>& classes,
                                      std::size_t world_classes, int border);

/// A line of `labelmap.txt`.
struct VocClass {
  std::string name;
  std::set<std::string> parts;  ///< parts that annotations of its objects may have
};

/// Writes the meaning of the indices in `SegmentationClass` as datumaro and CVAT read it: one line
/// per class, `name:red,green,blue:parts:actions`, with commas between parts. Datumaro rejects
/// annotations with a part that is not listed.
void writeLabelMap(std::ostream& stream, const std::vector<VocClass>& classes);

}  // namespace synthetic_dataset

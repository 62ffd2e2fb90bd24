#pragma once

#include <ostream>
#include <set>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "plugins/shared/colour_map.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// Classes, and objects of one image, that an index of 8 bits tells apart beside background and
/// void.
constexpr std::size_t kMostVocIndices = 254;

/// What Pascal VOC's segmentation pictures say of each pixel; CV_8UC1. 0 is the background; 255 is
/// void: an object without a label, or a border.
struct VocPictures {
  cv::Mat classes;  ///< the class's place among the classes and then those of the world, from 1
  cv::Mat objects;  ///< the object's place among the labelled ones, from 1
};

/// @param labelled  objects of the scene; those after the 254th are void among the objects
/// @param classes  of the dataset, at most 254
/// @param world_classes  how many of the world's there are, whose indices follow
/// @param border  how far from the next object or the background a pixel is void [px], 0 for none
[[nodiscard]] VocPictures vocPictures(const Scene& scene,
                                      const std::vector<const SceneObject*>& labelled,
                                      const std::vector<ClassInfo>& classes,
                                      std::size_t world_classes, int border);

/// A line of `labelmap.txt`.
struct VocClass {
  std::string name;
  std::set<std::string> parts;  ///< that annotations of its objects may have
};

/// What the indices in `SegmentationClass` mean, as datumaro and CVAT read it: a line a class,
/// `name:red,green,blue:parts:actions`, with commas between parts. Datumaro refuses annotations
/// with a part that no line has.
void writeLabelMap(std::ostream& stream, const std::vector<VocClass>& classes);

}  // namespace synthetic_dataset

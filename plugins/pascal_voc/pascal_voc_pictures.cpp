#include "plugins/pascal_voc/pascal_voc_pictures.h"

#include <algorithm>
#include <string>

#include <opencv2/imgproc.hpp>

#include "plugins/shared/pixel_map.h"

namespace synthetic_dataset {
namespace {

constexpr uchar kVoid = 255;

uchar indexOf(std::size_t place) {
  return place < kMostVocIndices ? static_cast<uchar>(place + 1) : kVoid;
}

std::size_t placeOf(int class_id, const std::vector<ClassInfo>& classes) {
  const auto found = std::find_if(classes.begin(), classes.end(),
                                  [&](const ClassInfo& each) { return each.id == class_id; });
  return static_cast<std::size_t>(found - classes.begin());
}

/// Marks pixels with a pixel of another instance within `border` along rows and columns.
cv::Mat bordersOf(const cv::Mat& instances, int border) {
  const cv::Mat square = cv::Mat::ones(2 * border + 1, 2 * border + 1, CV_8UC1);
  cv::Mat greatest;
  cv::Mat least;
  cv::dilate(instances, greatest, square);
  cv::erode(instances, least, square);
  return greatest != least;
}

/// A class's name for a line whose fields are separated by colons.
std::string plainName(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == ':' || c == '\n' || c == '\r'; }, '_');
  if (!name.empty() && name.front() == '#') name.front() = '_';  // not a comment
  return name;
}

}  // namespace

VocPictures vocPictures(const Scene& scene, const std::vector<const SceneObject*>& labelled,
                        const std::vector<ClassInfo>& classes, std::size_t world_classes,
                        int border) {
  // By instance. An object without a label is void: neither background nor something to be
  // detected.
  std::vector<uchar> class_of(scene.objects.size() + 1, kVoid);
  std::vector<uchar> object_of(scene.objects.size() + 1, kVoid);
  class_of[0] = object_of[0] = 0;
  for (std::size_t i = 0; i < labelled.size(); ++i) {
    const auto instance = static_cast<std::size_t>(labelled[i]->instance);
    class_of.at(instance) = indexOf(placeOf(labelled[i]->class_id, classes));
    object_of.at(instance) = indexOf(i);
  }
  const cv::Mat_<ushort> instances = scene.instance_map();
  VocPictures pictures{
      mapped<uchar>(instances, [&](ushort instance) { return class_of.at(instance); }),
      mapped<uchar>(instances, [&](ushort instance) { return object_of.at(instance); })};
  for (std::size_t i = 0; i < world_classes; ++i) {
    pictures.classes.setTo(indexOf(classes.size() + i),
                           (instances == 0) & (scene.world_map() == static_cast<double>(i + 1)));
  }
  if (border > 0) {
    const cv::Mat borders = bordersOf(instances, border);
    pictures.classes.setTo(kVoid, borders);
    pictures.objects.setTo(kVoid, borders);
  }
  return pictures;
}

void writeLabelMap(std::ostream& stream, const std::vector<VocClass>& classes) {
  const std::vector<cv::Vec3b> colours = vocColourMap();
  stream << "# label:color_rgb:parts:actions\nbackground:0,0,0::\n";
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const cv::Vec3b& colour = colours.at(i + 1);
    std::string parts;
    for (const std::string& part : classes[i].parts) {
      parts += (parts.empty() ? "" : ",") + plainName(part);
    }
    stream << plainName(classes[i].name) << ':' << std::to_string(colour[2]) << ','
           << std::to_string(colour[1]) << ',' << std::to_string(colour[0]) << ':' << parts
           << ":\n";
  }
}

}  // namespace synthetic_dataset

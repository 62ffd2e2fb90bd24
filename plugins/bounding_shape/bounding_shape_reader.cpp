#include <opencv2/imgcodecs.hpp>

#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::bounding_shape {
namespace {

/// `id x y z x y z ...`. The id may be several words, or none: coordinates come in threes.
DrawnLabel labelOf(const std::string& line, const std::filesystem::path& file) {
  const auto words = wordsOf(line);
  const std::size_t shortest_id = line.front() == ' ' ? 0 : 1;
  const std::size_t first = firstCoordinate(words, shortest_id, 3, file);
  DrawnLabel label;
  label.object_name = joined({words.begin(), words.begin() + static_cast<std::ptrdiff_t>(first)});
  label.caption =
      label.object_name + ": " + std::to_string((words.size() - first) / 3) + " vertices";
  return label;
}

// The vertices are in a frame chosen by the user; no file tells where they are in the image.
LabelledPicture readScene(const WrittenScene& scene) {
  LabelledPicture picture{readPicture(scene.file(".png"), cv::IMREAD_COLOR), {}};
  const std::filesystem::path file = scene.file(".txt");
  for (const std::string& line : readLines(file)) picture.labels.push_back(labelOf(line, file));
  return picture;
}

}  // namespace

Format format() { return {"synthetic_dataset/BoundingShape", false, readScene}; }

}  // namespace synthetic_dataset::formats::bounding_shape

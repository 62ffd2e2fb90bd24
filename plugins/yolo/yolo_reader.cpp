#include <opencv2/imgcodecs.hpp>

#include "plugins/readback/files.h"
#include "plugins/readback/format_readers.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::readback {

// Darknet: `class cx cy w h` as fractions of the image, a line an object. The class may hold
// spaces.
LabelledPicture readYolo(const WrittenScene& scene) {
  LabelledPicture picture{readPicture(scene.file(".png"), cv::IMREAD_COLOR), {}};
  const std::filesystem::path file = scene.file(".txt");
  const double width = picture.image.cols;
  const double height = picture.image.rows;
  for (const std::string& line : readLines(file)) {
    const auto words = wordsOf(line);
    if (words.size() < 5) throw Error("'" + file.string() + "': found the line '" + line + "'");
    const auto number = [&](std::size_t i) { return numberOf(words[words.size() - 4 + i], file); };
    const double u = number(0) * width;
    const double v = number(1) * height;
    const double half_width = 0.5 * number(2) * width;
    const double half_height = 0.5 * number(3) * height;
    DrawnLabel label;
    label.caption = words.front();
    for (std::size_t i = 1; i + 4 < words.size(); ++i) label.caption += " " + words[i];
    label.class_names = {label.caption};
    label.box = Box{u - half_width, v - half_height, u + half_width, v + half_height};
    picture.labels.push_back(std::move(label));
  }
  return picture;
}

}  // namespace synthetic_dataset::readback

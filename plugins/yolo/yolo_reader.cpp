#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "plugins/yolo/yolo_options.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::yolo {
namespace {

/// The name of the class whose number a label has, if the list exists: it is written when a dataset
/// is complete. Otherwise the label's own text.
std::string nameOf(const std::string& text, const std::vector<std::string>& names) {
  const bool is_number =
      text.find_first_not_of("0123456789") == std::string::npos && text.size() <= 6;
  const std::size_t number = is_number ? std::stoul(text) : names.size();
  return number < names.size() ? names[number] : text;
}

// Darknet: `class cx cy w h` as fractions of the image, one line per object. The class may contain
// spaces.
LabelledPicture readScene(const WrittenScene& scene) {
  LabelledPicture picture{readPicture(scene.file(".png"), cv::IMREAD_COLOR), {}};
  const std::filesystem::path file = scene.file(".txt");
  const std::filesystem::path list = scene.folder / kYoloNames;
  const auto names = std::filesystem::exists(list) ? readLines(list) : std::vector<std::string>();
  Parameters parameters(scene.settings);
  const PixelOrigin origin = readYoloOptions(parameters).origin;
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
    label.class_names = {joined({words.begin(), words.end() - 4})};
    label.caption = nameOf(label.class_names.front(), names);
    label.box = origin.back({u - half_width, v - half_height, u + half_width, v + half_height});
    picture.labels.push_back(std::move(label));
  }
  return picture;
}

}  // namespace

Format format() { return {"synthetic_dataset/Yolo", false, readScene}; }

}  // namespace synthetic_dataset::formats::yolo

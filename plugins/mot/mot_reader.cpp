#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "plugins/mot/mot_options.h"
#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "plugins/readback/sequence_files.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::mot {
namespace {

namespace fs = std::filesystem;

/// The name of a class's number: a line of gt/labels.txt.
std::string nameOf(const std::vector<std::string>& names, double number) {
  const bool is_known = number >= 1.0 && number <= static_cast<double>(names.size());
  return is_known ? names[static_cast<std::size_t>(number) - 1] : std::to_string(number);
}

// A line of gt.txt: the frame, then track, left, top, width, height, whether it counts, class and
// visibility.
LabelledPicture readScene(const WrittenScene& scene) {
  constexpr std::size_t kColumns = 8;  // after the frame number
  if (scene.files.empty()) throw Error("'" + scene.folder.string() + "': no image of the scene");
  const fs::path& image = scene.files.front();
  const SequenceFrame frame = frameOf(scene, image);
  const fs::path folder = scene.folder / frame.sequence;
  const fs::path file = folder / "gt" / "gt.txt";
  const fs::path linked = folder / "img1" / (frame.name + image.extension().string());
  LabelledPicture picture{readPicture(linked, cv::IMREAD_COLOR), {}};
  const std::vector<std::string> names = readLines(folder / "gt" / "labels.txt");
  for (const auto& words : scene.kept->get<SequenceLabels>(file)->of(frame, kColumns)) {
    const auto number = [&](std::size_t i) { return numberOf(words[i], file); };
    DrawnLabel label;
    label.class_names = {nameOf(names, number(6))};
    label.caption = label.class_names.front() + " " + words[0] + (number(5) == 0.0 ? " (0)" : "");
    label.box = Box{number(1) - 1.5, number(2) - 1.5, number(1) + number(3) - 1.5,
                    number(2) + number(4) - 1.5};
    picture.labels.push_back(std::move(label));
  }
  return picture;
}

}  // namespace

Format format() { return {"synthetic_dataset/Mot", true, readScene}; }

}  // namespace synthetic_dataset::formats::mot

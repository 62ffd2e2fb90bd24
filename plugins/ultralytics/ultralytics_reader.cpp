#include <algorithm>
#include <map>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "plugins/shared/json.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::ultralytics {
namespace {

namespace fs = std::filesystem;

/// Information in data.yaml that a label's line lacks.
struct DatasetYaml {
  std::map<std::string, std::string> names;  ///< of classes, by number
  bool has_keypoints = false;
};

/// The lines that the writer makes: `names:` with `  0: "robot"` below it, `kpt_shape: [9, 3]`. The
/// file does not exist before a dataset is complete.
DatasetYaml readYaml(const fs::path& file) {
  DatasetYaml yaml;
  if (!fs::exists(file)) {
    throw Error("'" + file.string() + "': no such file; only this says what the labels' numbers " +
                "mean (a run that was stopped leaves none)");
  }
  bool is_name = false;
  for (const std::string& line : readLines(file)) {
    if (line.front() != ' ') is_name = line == "names:";
    if (line.rfind("kpt_shape:", 0) == 0) yaml.has_keypoints = true;
    const std::size_t colon = line.find(": \"");
    if (!is_name || colon == std::string::npos) continue;
    // A quoted YAML string can be read as JSON.
    const auto name = jsonIfAny(line.substr(colon + 2));
    if (!name.is_string()) throw Error("'" + file.string() + "': found the line '" + line + "'");
    yaml.names[line.substr(2, colon - 2)] = name.get<std::string>();
  }
  return yaml;
}

/// Converts fractions to pixel coordinates.
class Fractions {
 public:
  Fractions(const std::vector<std::string>& words, const fs::path& file, const cv::Size& image)
      : words_(words), file_(file), image_(image) {}

  [[nodiscard]] double number(std::size_t i) const { return numberOf(words_.at(i), file_); }
  [[nodiscard]] cv::Point2d place(std::size_t i) const {
    return {number(i) * image_.width - 0.5, number(i + 1) * image_.height - 0.5};
  }
  [[nodiscard]] Box box(std::size_t i) const {
    const cv::Point2d centre = place(i);
    const double half_width = 0.5 * number(i + 2) * image_.width;
    const double half_height = 0.5 * number(i + 3) * image_.height;
    return {centre.x - half_width, centre.y - half_height, centre.x + half_width,
            centre.y + half_height};
  }

 private:
  const std::vector<std::string>& words_;
  const fs::path& file_;
  cv::Size image_;
};

// Ultralytics: a class's number and, as fractions of the image, a box; a box and keypoints if
// data.yaml says so; or a polygon.
LabelledPicture readScene(const WrittenScene& scene) {
  const fs::path file = scene.file(".txt");
  const auto image = std::find_if(scene.files.begin(), scene.files.end(),
                                  [](const fs::path& each) { return each.extension() != ".txt"; });
  if (image == scene.files.end()) throw Error("'" + file.string() + "': there is no image of it");
  LabelledPicture picture{readPicture(*image, cv::IMREAD_COLOR), {}};
  const DatasetYaml yaml = readYaml(scene.folder / "data.yaml");
  for (const std::string& line : readLines(file)) {
    const auto words = wordsOf(line);
    const bool is_box = words.size() == 5 || yaml.has_keypoints;
    if (words.size() < 5 || (!is_box && words.size() % 2 == 0) ||
        (is_box && (words.size() - 5) % 3 != 0)) {
      throw Error("'" + file.string() + "': found a line of " + std::to_string(words.size()) +
                  " words");
    }
    const Fractions fractions(words, file, picture.image.size());
    DrawnLabel label;
    const auto name = yaml.names.find(words.front());
    label.caption = name == yaml.names.end() ? words.front() : name->second;
    label.class_names = {label.caption};
    if (is_box) {
      label.box = fractions.box(1);
      for (std::size_t i = 5; i < words.size(); i += 3) {
        const double state = fractions.number(i + 2);
        if (state == 2.0) label.keypoints.push_back(fractions.place(i));
        if (state == 1.0) label.hidden_keypoints.push_back(fractions.place(i));
      }
    } else {
      label.polygons.emplace_back();
      for (std::size_t i = 1; i < words.size(); i += 2) {
        label.polygons.front().push_back(fractions.place(i));
      }
    }
    picture.labels.push_back(std::move(label));
  }
  return picture;
}

}  // namespace

Format format() { return {"synthetic_dataset/UltralyticsYolo", true, readScene}; }

}  // namespace synthetic_dataset::formats::ultralytics

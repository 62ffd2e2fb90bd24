/// The tool `draw_labels`: draws a written dataset's labels on one of its images, from the files
/// alone, for the eye.
///
///   rosrun synthetic_dataset draw_labels DATASET PICTURE [SCENE]
///
/// Draws what the Yolo and StvNet writers wrote: boxes, masks and keypoints. Without SCENE, the one
/// in the middle.

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "label_overlay.h"
#include "output/manifest.h"
#include "output/sqlite.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace {

using namespace synthetic_dataset;
namespace fs = std::filesystem;

/// What the manifest says: where the formats lie, by writer type, and which scenes there are.
struct Dataset {
  explicit Dataset(const fs::path& folder) {
    const output::SqliteDatabase database(output::manifestFile(folder.string()),
                                          output::SqliteDatabase::Mode::kExisting);
    output::SqliteStatement writers(database, "SELECT type, output_folder FROM writer");
    for (writers.start(); writers.step();) {
      folders.emplace(writers.text(0), folder / writers.text(1));
    }
    output::SqliteStatement scenes(database, "SELECT camera FROM scene ORDER BY \"index\"");
    for (scenes.start(); scenes.step();) cameras_of_scenes.push_back(scenes.text(0));
  }

  /// What a scene's files are called.
  [[nodiscard]] std::string sceneName(std::int64_t index) const {
    const std::set<std::string> cameras(cameras_of_scenes.begin(), cameras_of_scenes.end());
    if (index < 0 || index >= sceneCount()) {
      throw Error("found the scene " + std::to_string(index) + "; the dataset has 0 to " +
                  std::to_string(sceneCount() - 1));
    }
    const std::string number = sceneNumber(index / static_cast<std::int64_t>(cameras.size()));
    const std::string& camera = cameras_of_scenes[static_cast<std::size_t>(index)];
    return cameras.size() > 1 ? camera + "/" + number : number;
  }

  [[nodiscard]] std::int64_t sceneCount() const {
    return static_cast<std::int64_t>(cameras_of_scenes.size());
  }

  std::map<std::string, fs::path> folders;
  std::vector<std::string> cameras_of_scenes;
};

std::vector<std::string> wordsOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// The last `count` words of a line, as numbers: what stands before them may hold spaces.
std::vector<double> lastNumbers(const std::vector<std::string>& words, std::size_t count) {
  std::vector<double> numbers;
  for (std::size_t i = words.size() - count; i < words.size(); ++i) {
    numbers.push_back(std::stod(words[i]));
  }
  return numbers;
}

/// The Darknet label file: `class cx cy w h` as fractions of the image, a line an object.
std::vector<DrawnBox> readYolo(const fs::path& file, const cv::Size& image) {
  std::vector<DrawnBox> boxes;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    const auto words = wordsOf(line);
    if (words.size() < 5) throw Error(file.string() + ": found the line '" + line + "'");
    const auto n = lastNumbers(words, 4);
    const double u = n[0] * image.width;
    const double v = n[1] * image.height;
    const double half_width = 0.5 * n[2] * image.width;
    const double half_height = 0.5 * n[3] * image.height;
    boxes.push_back(
        {words.front(), {u - half_width, v - half_height, u + half_width, v + half_height}});
  }
  return boxes;
}

/// One object's stvNet files: its mask, and `id x y x y ...` as fractions of the image.
DrawnObject readStvNet(const fs::path& folder, const std::string& name, const cv::Size& image) {
  DrawnObject object;
  object.mask = cv::imread((folder / "mask" / (name + ".png")).string(), cv::IMREAD_GRAYSCALE);
  std::ifstream stream(folder / "labels" / (name + ".txt"));
  std::string line;
  std::getline(stream, line);
  const auto words = wordsOf(line);
  // The id is at least one word, and may be several: coordinates have a point and come in pairs.
  std::size_t coordinates = 0;
  while (coordinates + 1 < words.size() &&
         words[words.size() - 1 - coordinates].find('.') != std::string::npos) {
    ++coordinates;
  }
  coordinates -= coordinates % 2;
  const auto n = lastNumbers(words, coordinates);
  for (std::size_t i = 0; i + 1 < n.size(); i += 2) {
    object.keypoints.emplace_back(n[i] * image.width, n[i + 1] * image.height);
  }
  return object;
}

/// All objects of a scene, in alphabetical order of their folders.
std::vector<DrawnObject> readObjects(const fs::path& folder, const std::string& name,
                                     const cv::Size& image) {
  std::map<std::string, DrawnObject> objects;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (fs::exists(entry.path() / "mask" / (name + ".png"))) {
      objects.emplace(entry.path().filename().string(), readStvNet(entry.path(), name, image));
    }
  }
  std::vector<DrawnObject> result;
  for (auto& [folder_name, object] : objects) result.push_back(std::move(object));
  return result;
}

std::int64_t sceneIndex(const std::string& text) {
  std::int64_t index = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, fault] = std::from_chars(text.data(), end, index);
  if (fault != std::errc() || stopped != end) {
    throw Error("SCENE: found '" + text + "'; it should be a scene's index, a whole number");
  }
  return index;
}

void drawLabelsOf(const fs::path& folder, const std::string& picture, const char* scene) {
  const Dataset dataset(folder);
  const auto yolo = dataset.folders.find("synthetic_dataset/Yolo");
  if (yolo == dataset.folders.end()) {
    throw Error(folder.string() + ": the dataset has no writer of type synthetic_dataset/Yolo");
  }
  const std::string name =
      dataset.sceneName(scene != nullptr ? sceneIndex(scene) : dataset.sceneCount() / 2);
  const fs::path image_file = yolo->second / (name + ".png");
  const cv::Mat image = cv::imread(image_file.string(), cv::IMREAD_COLOR);
  if (image.empty()) throw Error(image_file.string() + ": no such image");
  std::vector<DrawnObject> objects;
  const auto stvnet = dataset.folders.find("synthetic_dataset/StvNet");
  if (stvnet != dataset.folders.end()) objects = readObjects(stvnet->second, name, image.size());
  const auto boxes = readYolo(yolo->second / (name + ".txt"), image.size());
  if (!cv::imwrite(picture, drawLabels(image, objects, boxes))) {
    throw Error(picture + ": cannot be written");
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) {
    std::cerr << "usage: draw_labels DATASET PICTURE [SCENE]\n";
    return 2;
  }
  try {
    drawLabelsOf(argv[1], argv[2], argc == 4 ? argv[3] : nullptr);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "draw_labels: " << error.what() << '\n';
    return 1;
  }
}

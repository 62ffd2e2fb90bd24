#include <opencv2/imgcodecs.hpp>

#include "plugins/readback/files.h"
#include "plugins/readback/format_readers.h"

namespace synthetic_dataset::readback {
namespace {

namespace fs = std::filesystem;

/// `id x y x y ...` as fractions of the image. The id is at least one word, and may be several:
/// coordinates have a point and come in pairs.
std::vector<cv::Point2d> readKeypoints(const fs::path& file, const cv::Size& image) {
  std::vector<cv::Point2d> keypoints;
  const auto lines = readLines(file);
  if (lines.empty()) return keypoints;
  const auto words = wordsOf(lines.front());
  std::size_t first = words.size();
  while (first > 1 && words[first - 1].find('.') != std::string::npos) --first;
  first += (words.size() - first) % 2;
  for (std::size_t i = first; i + 1 < words.size(); i += 2) {
    keypoints.emplace_back(numberOf(words[i], file) * image.width,
                           numberOf(words[i + 1], file) * image.height);
  }
  return keypoints;
}

}  // namespace

LabelledPicture readStvNet(const WrittenScene& scene) {
  LabelledPicture picture;
  for (const fs::path& image : scene.files) {
    if (image.parent_path().string().find("/JPEGImages") == std::string::npos) continue;
    // <object>/JPEGImages/<scene>.png, the scene's name with its camera's folder or without.
    const std::string path = image.string();
    const std::size_t at = path.rfind("/JPEGImages/");
    const fs::path object = path.substr(0, at);
    const fs::path number = path.substr(at + std::string("/JPEGImages/").size());
    if (picture.image.empty()) picture.image = readPicture(image, cv::IMREAD_COLOR);
    DrawnLabel label;
    label.caption = object.filename().string();
    label.object_name = object.lexically_relative(scene.folder).string();
    label.mask = readPicture(object / "mask" / number, cv::IMREAD_GRAYSCALE);
    fs::path text = object / "labels" / number;
    label.keypoints = readKeypoints(text.replace_extension(".txt"), picture.image.size());
    picture.labels.push_back(std::move(label));
  }
  return picture;
}

}  // namespace synthetic_dataset::readback

#include <opencv2/imgcodecs.hpp>

#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "plugins/shared/pixel_origin.h"

namespace synthetic_dataset::formats::stvnet {
namespace {

namespace fs = std::filesystem;

/// `id x y x y ...` as fractions of the image. The id is at least one word, and may be several:
/// coordinates come in pairs.
std::vector<cv::Point2d> readKeypoints(const fs::path& file, const cv::Size& image,
                                       const PixelOrigin& origin) {
  std::vector<cv::Point2d> keypoints;
  const auto lines = readLines(file);
  if (lines.empty()) return keypoints;
  const auto words = wordsOf(lines.front());
  for (std::size_t i = firstCoordinate(words, 1, 2, file); i + 1 < words.size(); i += 2) {
    keypoints.emplace_back(numberOf(words[i], file) * image.width - origin.offset,
                           numberOf(words[i + 1], file) * image.height - origin.offset);
  }
  return keypoints;
}

LabelledPicture readScene(const WrittenScene& scene) {
  Parameters parameters(scene.settings);
  const PixelOrigin origin = readPixelOrigin(parameters);
  LabelledPicture picture;
  for (const fs::path& image : scene.files) {
    if (image.parent_path().string().find("/JPEGImages") == std::string::npos) continue;
    // <object>/JPEGImages/<scene>.png, with or without the camera's folder in the scene's name.
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
    label.keypoints = readKeypoints(text.replace_extension(".txt"), picture.image.size(), origin);
    picture.labels.push_back(std::move(label));
  }
  return picture;
}

}  // namespace

Format format() { return {"synthetic_dataset/StvNet", false, readScene}; }

}  // namespace synthetic_dataset::formats::stvnet

#include <algorithm>
#include <set>
#include <tuple>

#include <opencv2/imgcodecs.hpp>

#include "plugins/pascal_voc/pascal_voc_options.h"
#include "plugins/pascal_voc/pascal_voc_pictures.h"
#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::pascal_voc {
namespace {

namespace fs = std::filesystem;

/// The text between <name> and </name>, searched from `begin` on.
/// @throws Error if there is no such element
std::string contentOf(const std::string& text, const std::string& name, const fs::path& file,
                      std::size_t begin = 0) {
  const std::size_t start = text.find("<" + name + ">", begin);
  const std::size_t end = text.find("</" + name + ">", start);
  if (start == std::string::npos || end == std::string::npos) {
    throw Error("'" + file.string() + "': there is no <" + name + ">");
  }
  const std::size_t first = start + name.size() + 2;
  return text.substr(first, end - first);
}

std::string unescaped(std::string text) {
  const std::vector<std::pair<std::string, std::string>> references = {
      {"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}};
  for (const auto& [reference, character] : references) {
    for (std::size_t at = 0; (at = text.find(reference, at)) != std::string::npos; ++at) {
      text.replace(at, reference.size(), character);
    }
  }
  return text;
}

DrawnLabel labelOf(const std::string& object, double first_pixel, const fs::path& file) {
  const auto pixel = [&](const std::string& name) {
    return numberOf(contentOf(object, name, file), file) - first_pixel;
  };
  DrawnLabel label;
  label.caption = unescaped(contentOf(object, "name", file));
  label.class_names = {label.caption};
  for (const std::string flag : {"truncated", "occluded", "difficult"}) {
    if (contentOf(object, flag, file) == "1") label.caption += ", " + flag;
  }
  label.box =
      Box{pixel("xmin") - 0.5, pixel("ymin") - 0.5, pixel("xmax") + 0.5, pixel("ymax") + 0.5};
  return label;
}

/// The masks in a picture of objects: one for each colour except the background's black and that of
/// void.
std::vector<DrawnLabel> masksOf(const fs::path& file) {
  constexpr std::size_t kMostColours = 256;  // of a palette
  const cv::Mat picture = readPicture(file, cv::IMREAD_COLOR);
  const cv::Mat_<cv::Vec3b> pixels = picture;
  std::set<std::tuple<int, int, int>> colours;
  for (const cv::Vec3b& pixel : pixels) {
    colours.emplace(pixel[0], pixel[1], pixel[2]);
    if (colours.size() > kMostColours) {
      throw Error("'" + file.string() + "': found more than 256 colours; it should have a palette");
    }
  }
  colours.erase({0, 0, 0});
  colours.erase({192, 224, 224});
  std::vector<DrawnLabel> labels;
  for (const auto& [blue, green, red] : colours) {
    DrawnLabel label;
    cv::inRange(picture, cv::Scalar(blue, green, red), cv::Scalar(blue, green, red), label.mask);
    labels.push_back(std::move(label));
  }
  return labels;
}

// Pascal VOC: one <object> per label with its <bndbox>, which includes the pixels at both edges; a
// palette picture of the objects.
LabelledPicture readScene(const WrittenScene& scene) {
  LabelledPicture picture;
  for (const fs::path& file : scene.files) {
    const fs::path folder = file.parent_path().filename();
    if (folder == "JPEGImages") picture.image = readPicture(file, cv::IMREAD_COLOR);
    if (folder == "SegmentationObject") {
      picture.labels = masksOf(file);
    }
  }
  const fs::path file = scene.file(".xml");
  const std::string text = readText(file);
  const bool is_from_zero = text.find("pixels are counted from 0") != std::string::npos;
  for (std::size_t at = 0; (at = text.find("<object>", at)) != std::string::npos; ++at) {
    picture.labels.push_back(
        labelOf(contentOf(text, "object", file, at), is_from_zero ? 0.0 : 1.0, file));
  }
  return picture;
}

}  // namespace

Format format() { return {"synthetic_dataset/PascalVoc", false, readScene}; }

}  // namespace synthetic_dataset::formats::pascal_voc

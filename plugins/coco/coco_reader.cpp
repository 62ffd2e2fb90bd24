#include <algorithm>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "plugins/coco/coco_index.h"
#include "plugins/coco/coco_options.h"
#include "plugins/coco/coco_rle.h"
#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "plugins/readback/json_file.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::coco {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The annotation file that contains an image, and the image's id in it.
struct ImageEntry {
  fs::path file;
  std::shared_ptr<const CocoIndex> index;
  std::int64_t image_id = 0;
};

std::vector<fs::path> annotationFiles(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;  // a missing folder has no files
  for (fs::directory_iterator each(folder, error), end; !error && each != end;
       each.increment(error)) {
    const fs::path& file = each->path();
    const bool is_panoptic = file.filename().string().rfind(kCocoPanoptic, 0) == 0;
    if (!is_panoptic && file.extension() == ".json") {
      files.push_back(file);
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

ImageEntry entryOf(const fs::path& folder, const fs::path& image, KeptFiles& kept) {
  for (const fs::path& file : annotationFiles(folder / "annotations")) {
    const std::string name = file.stem().string();  // instances_train
    const std::string split = name.substr(name.rfind('_') + 1);
    const auto index = kept.get<CocoIndex>(file);
    for (const fs::path& images : {folder / "images" / split, folder / "images"}) {
      if (const auto id = index->imageId(image.lexically_relative(images).string())) {
        return {file, index, *id};
      }
    }
  }
  throw Error("'" + (folder / "annotations").string() + "': no file lists '" + image.string() +
              "'");
}

void addSegmentation(const json& segmentation, const cv::Size& size, DrawnLabel& label) {
  if (segmentation.is_object()) {
    label.mask = maskOfCocoCounts(segmentation.at("counts").get<std::string>(), size);
    return;
  }
  for (const json& numbers : segmentation) {
    label.polygons.emplace_back();
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
      label.polygons.back().emplace_back(numbers.at(i).get<double>() - 0.5,
                                         numbers.at(i + 1).get<double>() - 0.5);
    }
  }
}

void addKeypoints(const json& numbers, const json& category, DrawnLabel& label) {
  std::map<std::size_t, cv::Point2d> places;  // by the keypoints' numbers from 1
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    const cv::Point2d place(numbers.at(i).get<double>(), numbers.at(i + 1).get<double>());
    const int flag = integerOf(numbers.at(i + 2));
    if (flag == 0) continue;
    (flag == 2 ? label.keypoints : label.hidden_keypoints).push_back(place);
    places[i / 3 + 1] = place;
  }
  if (!category.contains("skeleton")) return;
  for (const json& line : category.at("skeleton")) {
    const auto from = places.find(integerOf<std::size_t>(line.at(0)));
    const auto to = places.find(integerOf<std::size_t>(line.at(1)));
    if (from != places.end() && to != places.end()) {
      label.lines.push_back({from->second, to->second});
    }
  }
}

/// @param category  the annotation's
DrawnLabel labelOf(const json& annotation, const json& category, const cv::Size& image) {
  DrawnLabel label;
  label.caption = category.at("name").get<std::string>();
  label.class_names = {label.caption};
  if (const auto more = annotation.find("synthetic_dataset"); more != annotation.end()) {
    label.object_name = more->at("object").get<std::string>();
  }
  const auto box = annotation.at("bbox").get<std::array<double, 4>>();
  label.box = Box{box[0] - 0.5, box[1] - 0.5, box[0] + box[2] - 0.5, box[1] + box[3] - 0.5};
  addSegmentation(annotation.at("segmentation"), image, label);
  if (annotation.contains("keypoints")) {
    addKeypoints(annotation.at("keypoints"), category, label);
  }
  return label;
}

// COCO: boxes, run lengths or polygons in coordinates in which the image spans 0 to its width;
// keypoints in those in which pixel centres are integers.
LabelledPicture readScene(const WrittenScene& scene) {
  const fs::path images = scene.folder / "images";
  const auto image = std::find_if(
      scene.files.begin(), scene.files.end(),
      [&](const fs::path& file) { return file.string().rfind(images.string() + "/", 0) == 0; });
  if (image == scene.files.end()) throw Error("'" + images.string() + "': no image of the scene");
  LabelledPicture picture{readPicture(*image, cv::IMREAD_COLOR), {}};
  const ImageEntry entry = entryOf(scene.folder, *image, *scene.kept);
  readingJson(entry.file, [&] {
    std::map<std::int64_t, json> categories;
    for (const json& each : entry.index->categories()) {
      categories[integerOf<std::int64_t>(each.at("id"))] = each;
    }
    for (const json& each : entry.index->annotationsOf(entry.image_id)) {
      const json& category = categories[integerOf<std::int64_t>(each.at("category_id"))];
      picture.labels.push_back(labelOf(each, category, picture.image.size()));
    }
  });
  return picture;
}

}  // namespace

Format format() { return {"synthetic_dataset/Coco", true, readScene}; }

}  // namespace synthetic_dataset::formats::coco

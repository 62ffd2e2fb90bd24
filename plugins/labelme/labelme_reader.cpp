#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "plugins/readback/json_file.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::labelme {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

DrawnLabel labelOf(const json& shape) {
  DrawnLabel label;
  label.caption = shape.at("label").get<std::string>();
  label.class_names = {label.caption};
  label.object_name = shape.at("description").get<std::string>();
  const auto points = shape.at("points").get<std::vector<std::array<double, 2>>>();
  if (shape.at("shape_type") == "rectangle") {
    label.box = Box{points.at(0)[0] - 0.5, points.at(0)[1] - 0.5, points.at(1)[0] - 0.5,
                    points.at(1)[1] - 0.5};
    return label;
  }
  label.polygons.emplace_back();
  for (const auto& [x, y] : points) label.polygons.back().emplace_back(x, y);
  return label;
}

LabelledPicture readScene(const WrittenScene& scene) {
  const fs::path file = scene.file(".json");
  return readJson(file, [&](const json& content) {
    const fs::path image = file.parent_path() / content.at("imagePath").get<std::string>();
    LabelledPicture picture{readPicture(image, cv::IMREAD_COLOR), {}};
    for (const json& shape : content.at("shapes")) {
      if (shape.at("shape_type") == "rectangle" && shape.at("points").size() != 2) {
        throw Error("'" + file.string() + "': found a rectangle that does not have two corners");
      }
      picture.labels.push_back(labelOf(shape));
    }
    return picture;
  });
}

}  // namespace

Format format() { return {"synthetic_dataset/LabelMe", false, readScene}; }

}  // namespace synthetic_dataset::formats::labelme

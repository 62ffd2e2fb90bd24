#include <array>

#include <opencv2/imgcodecs.hpp>

#include "plugins/readback/format.h"
#include "plugins/readback/json_file.h"

namespace synthetic_dataset::formats::dope {
namespace {

using Json = nlohmann::json;

cv::Point2d pointOf(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>()};
}

/// The box in either style.
std::optional<Box> boxOf(const Json& object) {
  if (const auto ndds = object.find("bounding_box"); ndds != object.end()) {
    const cv::Point2d low = pointOf(ndds->at("top_left"));  // row, column
    const cv::Point2d high = pointOf(ndds->at("bottom_right"));
    return Box{low.y - 0.5, low.x - 0.5, high.y - 0.5, high.x - 0.5};
  }
  const auto dope = object.find("bounding_box_minx_maxx_miny_maxy");
  if (dope == object.end()) return std::nullopt;
  return Box{dope->at(0).get<double>() - 0.5, dope->at(2).get<double>() - 0.5,
             dope->at(1).get<double>() + 0.5, dope->at(3).get<double>() + 0.5};
}

/// The pose in metres; NDDS uses centimetres.
Pose poseOf(const Json& object) {
  const double metre = object.contains("pose_transform") ? 100.0 : 1.0;
  const auto p = object.at("location").get<std::array<double, 3>>();
  const auto q = object.at("quaternion_xyzw").get<std::array<double, 4>>();
  return makePose(Eigen::Vector3d(p[0], p[1], p[2]) / metre,
                  Eigen::Quaterniond(q[3], q[0], q[1], q[2]));
}

DrawnLabel labelOf(const Json& object) {
  DrawnLabel label;
  label.caption = object.at("class").get<std::string>();
  label.class_names = {label.caption};
  label.object_name = object.value("name", "");
  if (object.contains("quaternion_xyzw")) label.X_CO = poseOf(object);
  label.box = boxOf(object);
  const Json& places = object.at("projected_cuboid");
  for (std::size_t i = 0; i < 4; ++i) {  // upper face, lower face, edges between
    const std::size_t next = (i + 1) % 4;
    label.lines.push_back({pointOf(places.at(i)), pointOf(places.at(next))});
    label.lines.push_back({pointOf(places.at(i + 4)), pointOf(places.at(next + 4))});
    label.lines.push_back({pointOf(places.at(i)), pointOf(places.at(i + 4))});
  }
  const bool is_ninth = places.size() == 9;
  label.keypoints = {pointOf(is_ninth ? places.at(8) : object.at("projected_cuboid_centroid"))};
  return label;
}

LabelledPicture readScene(const WrittenScene& scene) {
  LabelledPicture picture{readPicture(scene.file(".png"), cv::IMREAD_COLOR), {}};
  picture.labels = readJson(scene.file(".json"), [](const Json& json) {
    std::vector<DrawnLabel> labels;
    for (const Json& object : json.at("objects")) labels.push_back(labelOf(object));
    return labels;
  });
  return picture;
}

}  // namespace

Format format() { return {"synthetic_dataset/Dope", false, readScene}; }

}  // namespace synthetic_dataset::formats::dope

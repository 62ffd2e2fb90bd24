#include "output/manifest/scene_facts.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include <opencv2/core.hpp>

#include "output/files/digest.h"

namespace synthetic_dataset::output {
namespace {

template <class T>
std::optional<T> ifKnown(const Required<T>& value) {
  return value.isKnown() ? std::optional<T>(value()) : std::nullopt;
}

std::optional<Box> ifKnown(const Required<std::optional<Box>>& box) {
  return box.isKnown() ? box() : std::nullopt;
}

/// @param depth  CV_32FC1
std::vector<float> depthCells(const cv::Mat& depth) {
  std::vector<float> cells;
  for (int top = 0; top < depth.rows; top += kDepthCell) {
    for (int left = 0; left < depth.cols; left += kDepthCell) {
      const cv::Mat cell = depth(cv::Rect(left, top, std::min(kDepthCell, depth.cols - left),
                                          std::min(kDepthCell, depth.rows - top)));
      double least = 0.0;
      double greatest = 0.0;
      cv::minMaxLoc(cell, &least, &greatest);
      cells.push_back(static_cast<float>(cv::sum(cell)[0]));
      cells.push_back(static_cast<float>(least));
      cells.push_back(static_cast<float>(greatest));
    }
  }
  return cells;
}

}  // namespace

ObjectFacts objectFacts(const SceneObject& object) {
  ObjectFacts facts;
  facts.X_GO = object.X_GO;
  facts.distance = object.X_CO ? std::optional(object.distance()) : std::nullopt;
  facts.in_view = object.in_view;
  facts.dropped = object.dropped;
  facts.loose_box = object.loose_box;
  facts.silhouette_box = ifKnown(object.silhouette_box);
  facts.visible_box = ifKnown(object.visible_box);
  facts.silhouette_pixels = ifKnown(object.pixels.silhouette);
  facts.visible_pixels = ifKnown(object.pixels.visible);
  facts.visibility = ifKnown(object.visibility);
  facts.truncation = ifKnown(object.truncation);
  facts.cuboid_O = object.cuboid_O;
  facts.bounding_shape_O = object.bounding_shape_O;
  const std::size_t count = std::max(object.keypoints_O.size(), object.keypoints.size());
  for (std::size_t i = 0; i < count; ++i) {
    KeypointFacts keypoint;
    if (i < object.keypoints_O.size()) keypoint.p_O = object.keypoints_O[i];
    if (i < object.keypoints.size()) {
      keypoint.pixel = object.keypoints[i].pixel;
      keypoint.state = ifKnown(object.keypoints[i].state);
    }
    facts.keypoints.push_back(keypoint);
  }
  facts.silhouette_in_image = ifKnown(object.pixels.silhouette_in_image);
  facts.silhouette = ifKnown(object.silhouette);
  facts.visible_mask = ifKnown(object.visible_mask);
  return facts;
}

SceneFacts sceneFacts(const Scene& scene) {
  SceneFacts facts;
  facts.index = scene.index;
  facts.stamp = scene.stamp;
  facts.instant = scene.instant;
  facts.camera = scene.camera_name;
  facts.width = scene.camera.width();
  facts.height = scene.camera.height();
  facts.split = scene.split;
  facts.X_GC = scene.X_GC;
  facts.camera_model = scene.camera;
  if (!scene.image.empty()) facts.pictures["image"] = scene.image;
  const auto add = [](const char* name, const Required<cv::Mat>& picture,
                      std::map<std::string, cv::Mat>& known) {
    if (picture.isKnown()) known[name] = picture();
  };
  add("class_map", scene.class_map, facts.pictures);
  add("depth", scene.depth, facts.pictures);
  add("normals", scene.normals, facts.pictures);
  add("optical_flow", scene.optical_flow, facts.pictures);
  add("world_map", scene.world_map, facts.link_maps);
  add("part_map", scene.part_map, facts.link_maps);
  return facts;
}

PictureFacts pictureFacts(const std::string& name, const cv::Mat& pixels) {
  PictureFacts facts{name, digestOfPixels(pixels), {}};
  if (name == "depth") facts.cells = depthCells(pixels);
  return facts;
}

cv::Mat normalColours(const cv::Mat& normals) {
  const auto byteOf = [](float coordinate) {
    return cv::saturate_cast<uchar>((coordinate + 1.0F) * 0.5F * 255.0F);
  };
  const cv::Mat_<cv::Vec3f> from = normals;
  cv::Mat_<cv::Vec3b> colours(from.size());
  std::transform(from.begin(), from.end(), colours.begin(), [&](const cv::Vec3f& n) {
    const bool is_nothing = n == cv::Vec3f(0.0F, 0.0F, 0.0F);
    return is_nothing ? cv::Vec3b() : cv::Vec3b(byteOf(n[2]), byteOf(n[1]), byteOf(n[0]));
  });
  return colours;
}

cv::Mat depthNumbers(const cv::Mat& depth, double per_metre) {
  constexpr double kTooGreat = 65536.0;
  cv::Mat_<std::uint16_t> numbers(depth.size());
  for (int row = 0; row < depth.rows; ++row) {
    const auto* from = depth.ptr<float>(row);
    std::uint16_t* to = numbers[row];
    for (int column = 0; column < depth.cols; ++column) {
      // Cut off, this is the nearest number: what is below 1 has none.
      const double number = double{from[column]} * per_metre + 0.5;
      to[column] = number >= 1.0 && number < kTooGreat
                       ? static_cast<std::uint16_t>(static_cast<int>(number))
                       : std::uint16_t{0};
    }
  }
  return numbers;
}

std::string digestOfPixels(const cv::Mat& pixels) {
  Digest digest;
  const std::size_t size = pixels.elemSize() * static_cast<std::size_t>(pixels.cols);
  for (int row = 0; row < pixels.rows; ++row) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes are bytes
    digest.add(std::string_view(reinterpret_cast<const char*>(pixels.ptr(row)), size));
  }
  return digest.text();
}

}  // namespace synthetic_dataset::output

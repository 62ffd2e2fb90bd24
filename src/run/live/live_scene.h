#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "base/scene_facts.h"
#include "synthetic_dataset/scene.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// A scene as the run makes it, with all labels, and the time it took.
struct LiveScene {
  Scene scene;                     ///< without transforms
  double seconds = 0.0;            ///< from the call until the scene is finished
  double processor_seconds = 0.0;  ///< of all threads
};

/// A picture with one set of randomization draws.
struct LiveDraw {
  cv::Mat picture;                     ///< CV_8UC3
  std::vector<base::DrawFacts> draws;  ///< what was drawn for it
};

/// The randomization draws, by full name.
[[nodiscard]] Value drawsValue(const LiveDraw& draw);

/// The scene without its pictures, for programs: the camera with its pose, and for each object
/// boxes, polygons around its visible mask, keypoints, the cuboid's corners, the projected bounding
/// shape, the distance. Pixel centres have integer coordinates. Values that do not project onto the
/// image plane are null.
[[nodiscard]] Value::Map sceneValue(const LiveScene& live);

/// A depth map for display, CV_8UC3: near is bright; black where there is nothing.
/// @param depth  as Scene::depth
[[nodiscard]] cv::Mat depthPicture(const cv::Mat& depth);

/// The object that each pixel shows, each in its own colour, CV_8UC3; the world is black.
/// @param instance_map  as Scene::instance_map
[[nodiscard]] cv::Mat instancePicture(const cv::Mat& instance_map);

}  // namespace synthetic_dataset::run

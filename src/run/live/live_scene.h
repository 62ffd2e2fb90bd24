#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "base/scene_facts.h"
#include "synthetic_dataset/scene.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// A scene as the run makes it, with all labels, and what it took.
struct LiveScene {
  Scene scene;                     ///< knows no transforms
  double seconds = 0.0;            ///< from the call to the scene
  double processor_seconds = 0.0;  ///< of all threads
};

/// A picture with some draws of the randomisation.
struct LiveDraw {
  cv::Mat picture;                     ///< CV_8UC3
  std::vector<base::DrawFacts> draws;  ///< what was drawn for it
};

/// What was drawn, by its full name.
[[nodiscard]] Value drawsValue(const LiveDraw& draw);

/// The scene without its pictures, for programs: the camera with its pose, and of each object
/// boxes, polygons around its visible mask, keypoints, the cuboid's corners, the projected bounding
/// shape, the distance. Pixels' centres have whole coordinates. What has no place on the image's
/// plane is null.
[[nodiscard]] Value::Map sceneValue(const LiveScene& live);

/// A depth map for the eye, CV_8UC3: near is bright; black where nothing is.
/// @param depth  as Scene::depth
[[nodiscard]] cv::Mat depthPicture(const cv::Mat& depth);

/// Which object each pixel shows, in colours of their own, CV_8UC3; the world is black.
/// @param instance_map  as Scene::instance_map
[[nodiscard]] cv::Mat instancePicture(const cv::Mat& instance_map);

}  // namespace synthetic_dataset::run

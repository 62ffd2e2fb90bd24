#pragma once

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// What one look at the labels gives, pixel by pixel, sampled at the pixels' centres.
struct LabelImages {
  cv::Mat ids;    ///< CV_32SC1: the identifier that was drawn, 0 where nothing was
  cv::Mat depth;  ///< CV_32FC1: z in the optical frame [m], 0 where nothing was drawn

  // Empty unless asked for.

  /// CV_32SC1: the link's index among the world's links + 1, 0 where nothing was drawn.
  cv::Mat links;

  /// CV_32FC3: the surface's unit normal (x, y, z) in the optical frame, towards the camera; 0
  /// where nothing was drawn. That of the vertices, without normal maps.
  cv::Mat normals;

  /// CV_32FC1: the distance from the camera's centre [m], 0 where nothing was drawn.
  cv::Mat range;
};

}  // namespace synthetic_dataset::render

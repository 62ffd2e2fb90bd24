#pragma once

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// The result of a label pass, sampled at the pixels' centres.
struct LabelImages {
  cv::Mat ids;    ///< CV_32SC1: the identifier that was drawn, 0 where nothing was
  cv::Mat depth;  ///< CV_32FC1: z in the optical frame [m], 0 where nothing was drawn

  // Empty unless requested in the LabelPass.

  /// CV_32SC1: the link's index among the world's links + 1, 0 where nothing was drawn.
  cv::Mat links;

  /// CV_32FC3: the surface's unit normal (x, y, z) in the optical frame, towards the camera; 0
  /// where nothing was drawn. Interpolated from the vertices, without normal maps.
  cv::Mat normals;

  /// CV_32FC1: the distance from the camera's centre [m], 0 where nothing was drawn.
  cv::Mat range;
};

}  // namespace synthetic_dataset::render

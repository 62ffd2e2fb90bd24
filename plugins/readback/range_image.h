#pragma once

#include <cstdint>
#include <map>

#include <opencv2/core/mat.hpp>

#include "plugins/readback/cloud_colours.h"
#include "plugins/readback/labelled_cloud.h"

namespace synthetic_dataset::formats {

/// Range images from the scanner's viewpoint: columns by azimuth, left to right as the scanner sees
/// them, rows by ring if the files give it, otherwise by elevation; black where there is no point.
struct RangeImages {
  cv::Mat ranges;         ///< CV_8UC3: near is bright, far is dark
  cv::Mat labels;         ///< CV_8UC3: each point in its class's colour, or grey
  double nearest = 0.0;   ///< range of the brightest colour [m]
  double farthest = 1.0;  ///< range of the darkest colour [m]
  double left = 0.0;      ///< azimuth of the left edge [rad]: 0 ahead, increasing to the left
  double right = 0.0;     ///< azimuth of the right edge [rad]
};

[[nodiscard]] RangeImages rangeImages(const LabelledCloud& cloud,
                                      const std::map<std::uint16_t, ClassColour>& colours,
                                      const cv::Size& size);

/// The colour scale of ranges, from the nearest on the left to the farthest. CV_8UC3
[[nodiscard]] cv::Mat rangeScale(const cv::Size& size);

}  // namespace synthetic_dataset::formats

#pragma once

#include <cstdint>
#include <map>

#include <opencv2/core/mat.hpp>

#include "plugins/readback/cloud_colours.h"
#include "plugins/readback/labelled_cloud.h"

namespace synthetic_dataset::formats {

/// What a scanner sees from where it stands: columns by azimuth, from the left to the right as it
/// sees them, rows by ring where the files say so, else by elevation; black where nothing was.
struct RangeImages {
  cv::Mat ranges;         ///< CV_8UC3: near is bright, far is dark
  cv::Mat labels;         ///< CV_8UC3: of each point its class's colour, or a grey
  double nearest = 0.0;   ///< which range is the brightest [m]
  double farthest = 1.0;  ///< which is the darkest [m]
  double left = 0.0;      ///< the azimuth of the left edge [rad], 0 ahead, greater to the left
  double right = 0.0;     ///< of the right edge
};

[[nodiscard]] RangeImages rangeImages(const LabelledCloud& cloud,
                                      const std::map<std::uint16_t, ClassColour>& colours,
                                      const cv::Size& size);

/// The colours of ranges from the nearest, on the left, to the farthest. CV_8UC3
[[nodiscard]] cv::Mat rangeScale(const cv::Size& size);

}  // namespace synthetic_dataset::formats

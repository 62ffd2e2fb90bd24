#pragma once

#include <cstdint>
#include <map>
#include <string>

#include <opencv2/core/mat.hpp>

#include "plugins/readback/cloud_colours.h"
#include "plugins/readback/labelled_cloud.h"

namespace synthetic_dataset::formats {

/// A cloud seen from above.
struct CloudFromAbove {
  cv::Mat picture;    ///< CV_8UC3
  double grid = 1.0;  ///< from line to line [m]
};

/// A length as people write it: 0.5, 20.
[[nodiscard]] std::string metresText(double metres);

/// Draws a cloud seen from above: ahead is up, left is left. Nearly all of its points are in the
/// picture, coloured by class, above a grid of metres; the scanner is an arrow; objects have their
/// boxes' outlines, and how many points they have.
/// @param size  the picture is square [px]
[[nodiscard]] CloudFromAbove cloudFromAbove(const LabelledCloud& cloud,
                                            const std::map<std::uint16_t, ClassColour>& colours,
                                            int size);

}  // namespace synthetic_dataset::formats

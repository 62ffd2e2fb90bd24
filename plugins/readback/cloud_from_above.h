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
  double grid = 1.0;  ///< spacing of the grid lines [m]
};

/// A length in readable form: 0.5, 20.
[[nodiscard]] std::string metresText(double metres);

/// Draws a cloud seen from above: forward is up, left is left. The picture shows nearly all of its
/// points, coloured by class, over a metric grid; an arrow for the scanner; and for each object its
/// box's outline and its number of points.
/// @param size  the picture is square [px]
[[nodiscard]] CloudFromAbove cloudFromAbove(const LabelledCloud& cloud,
                                            const std::map<std::uint16_t, ClassColour>& colours,
                                            int size);

}  // namespace synthetic_dataset::formats

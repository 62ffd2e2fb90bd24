#pragma once

#include <string>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::world {

/// Paints a stand-in for one of Gazebo Classic's pictures, the same pixels each time: boards,
/// bricks, asphalt and so on if the picture shows such a thing, else a plain light grey.
/// @param file  its name in Gazebo's media/materials/textures ("wood.jpg")
/// @return CV_8UC4, opaque; opposite edges match
[[nodiscard]] cv::Mat paintGazeboPicture(const std::string& file);

/// Whether Gazebo ships a picture of this name for which a stand-in is painted.
[[nodiscard]] bool isGazeboPicture(const std::string& file);

}  // namespace synthetic_dataset::world

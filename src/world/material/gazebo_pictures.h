#pragma once

#include <string>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::world {

/// Paints a stand-in for one of Gazebo Classic's pictures, the same pixels each time: boards,
/// bricks, asphalt and so on where the picture shows such, else a plain light grey.
/// @param file  its name in Gazebo's media/materials/textures ("wood.jpg")
/// @return CV_8UC4, opaque; its edges fit each other
[[nodiscard]] cv::Mat paintGazeboPicture(const std::string& file);

/// Whether Gazebo ships a picture of this name for which a stand-in is painted.
[[nodiscard]] bool isGazeboPicture(const std::string& file);

}  // namespace synthetic_dataset::world

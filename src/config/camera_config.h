#pragma once

#include <string>
#include <vector>

#include "scene/camera_options.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::config {

/// The camera of the group `camera`, or those of the group `cameras`, in alphabetical order.
/// What is wrong is noted in `root`, with a harmless value in its place.
[[nodiscard]] std::vector<scene::CameraOptions> readCameras(Parameters root);

/// What a part of a topic's name says, as image_proc names its topics: image_rect,
/// image_rect_color/compressed.
[[nodiscard]] bool isRectifiedTopic(const std::string& topic);

}  // namespace synthetic_dataset::config

#pragma once

#include <functional>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// Makes a picture of what OpenGL has drawn; may be called from any thread while the renderer
/// exists.
using PendingPicture = std::function<cv::Mat()>;

}  // namespace synthetic_dataset::render

#pragma once

#include <functional>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// Makes a picture of what OpenGL has drawn; may be called in any thread, while the renderer lives.
using PendingPicture = std::function<cv::Mat()>;

}  // namespace synthetic_dataset::render

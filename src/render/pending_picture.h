#pragma once

#include <functional>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// Makes a picture of what OpenGL has drawn; may be called in any thread, while the renderer lives.
using PendingPicture = std::function<cv::Mat()>;

/// The same picture, made from now on in a thread of its own.
[[nodiscard]] PendingPicture begun(PendingPicture picture);

}  // namespace synthetic_dataset::render

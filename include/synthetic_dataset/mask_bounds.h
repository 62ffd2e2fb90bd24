#pragma once

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset {
inline namespace v1 {

/// Round all pixels of a mask that are not 0 [px]; empty where there are none, or no pixels at all.
///
/// cv::boundingRect of OpenCV 4.6 says too little of narrow shapes whose rows do not begin at
/// multiples of four bytes, as those of parts of an image, or of images of odd widths.
/// @param mask  CV_8UC1, of any size, maybe a part of another image
[[nodiscard]] cv::Rect maskBounds(const cv::Mat& mask);

}  // namespace v1
}  // namespace synthetic_dataset

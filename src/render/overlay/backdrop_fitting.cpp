#include "render/overlay/backdrop_fitting.h"

#include <algorithm>
#include <cmath>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "render/pixels/light_picture.h"

namespace synthetic_dataset::render {
namespace {

int share(int length, int numerator, int denominator) {
  const double exact = static_cast<double>(length) * numerator / denominator;
  return std::max(1, static_cast<int>(std::lround(exact)));
}

}  // namespace

cv::Rect partFilling(const cv::Size& picture, const cv::Size& image) {
  const cv::Size part(std::min(picture.width, share(picture.height, image.width, image.height)),
                      std::min(picture.height, share(picture.width, image.height, image.width)));
  return {cv::Point((picture.width - part.width) / 2, (picture.height - part.height) / 2), part};
}

cv::Mat scaledTo(const cv::Size& size, const cv::Mat& picture) {
  if (picture.size() == size) return picture;
  const bool shrinks = size.width < picture.cols || size.height < picture.rows;
  cv::Mat light;
  cv::resize(toLight(picture, PixelMeaning::kColour), light, size, 0.0, 0.0,
             shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
  return fromLight(light, PixelMeaning::kColour);
}

}  // namespace synthetic_dataset::render

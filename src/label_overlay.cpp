#include "label_overlay.h"

#include <algorithm>
#include <array>

#include <opencv2/imgproc.hpp>

namespace synthetic_dataset {
namespace {

/// Colours that stay apart for the colour-blind (Okabe and Ito 2008), blue green red.
const std::array<cv::Scalar, 6> kColours = {cv::Scalar(233, 180, 86),  cv::Scalar(115, 158, 0),
                                            cv::Scalar(167, 121, 204), cv::Scalar(66, 228, 240),
                                            cv::Scalar(0, 159, 230),   cv::Scalar(0, 94, 213)};
const cv::Scalar kBoxColour(240, 240, 240);
const cv::Scalar kDark(20, 20, 20);

constexpr int kSubpixelBits = 4;  // OpenCV draws at fractions of a pixel when points come shifted

cv::Point shifted(double u, double v) {
  constexpr double kScale = 1 << kSubpixelBits;
  return {cvRound(u * kScale), cvRound(v * kScale)};
}

void tint(cv::Mat& image, const cv::Mat& mask, const cv::Scalar& colour) {
  constexpr double kStrength = 0.45;
  cv::Mat tinted;
  cv::addWeighted(image, 1.0 - kStrength, cv::Mat(image.size(), image.type(), colour), kStrength,
                  0.0, tinted);
  tinted.copyTo(image, mask);
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(mask, outlines, cv::RETR_LIST, cv::CHAIN_APPROX_NONE);
  cv::drawContours(image, outlines, -1, colour, 1);
}

void dot(cv::Mat& image, const cv::Point2d& place, const cv::Scalar& colour) {
  cv::circle(image, shifted(place.x, place.y), 3 << kSubpixelBits, kDark, cv::FILLED, cv::LINE_AA,
             kSubpixelBits);
  cv::circle(image, shifted(place.x, place.y), 2 << kSubpixelBits, colour, cv::FILLED, cv::LINE_AA,
             kSubpixelBits);
}

void outline(cv::Mat& image, const DrawnBox& drawn) {
  constexpr double kSize = 0.42;
  const Box& box = drawn.box;
  cv::rectangle(image, shifted(box.left, box.top), shifted(box.right, box.bottom), kBoxColour, 1,
                cv::LINE_AA, kSubpixelBits);
  int baseline = 0;
  const cv::Size text =
      cv::getTextSize(drawn.caption, cv::FONT_HERSHEY_SIMPLEX, kSize, 1, &baseline);
  const cv::Point corner(cvRound(box.left), std::max(cvRound(box.top) - 3, text.height + 3));
  cv::rectangle(image, corner + cv::Point(-1, 4),
                corner + cv::Point(text.width + 4, -text.height - 3), kBoxColour, cv::FILLED);
  cv::putText(image, drawn.caption, corner + cv::Point(2, 0), cv::FONT_HERSHEY_SIMPLEX, kSize,
              kDark, 1, cv::LINE_AA);
}

}  // namespace

cv::Mat drawLabels(const cv::Mat& image, const std::vector<DrawnObject>& objects,
                   const std::vector<DrawnBox>& boxes) {
  cv::Mat result = image.clone();
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (!objects[i].mask.empty()) tint(result, objects[i].mask, kColours[i % kColours.size()]);
  }
  for (const DrawnBox& box : boxes) outline(result, box);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    for (const cv::Point2d& point : objects[i].keypoints) {
      dot(result, point, kColours[i % kColours.size()]);
    }
  }
  return result;
}

}  // namespace synthetic_dataset

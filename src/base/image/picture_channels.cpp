#include "base/image/picture_channels.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace synthetic_dataset::base {
namespace {

constexpr int kRed = 2;
constexpr int kAlpha = 3;

/// The distance between the heights 0 and 1, in pixels. Files give no unit for heights; with this,
/// the steepest slope is 45 degrees.
constexpr float kBumpDepth = 2.0F;

cv::Mat channel(const cv::Mat& picture, int index) {
  cv::Mat result;
  cv::extractChannel(picture, result, index);
  return result;
}

cv::Mat grey(const cv::Mat& picture) {
  cv::Mat result;
  cv::cvtColor(picture, result, cv::COLOR_BGRA2GRAY);
  return result;
}

cv::Mat fromGrey(const cv::Mat& values) {
  cv::Mat result;
  cv::cvtColor(values, result, cv::COLOR_GRAY2BGRA);
  return result;
}

std::uint8_t encoded(float component) {
  return static_cast<std::uint8_t>((component * 0.5F + 0.5F) * 255.0F + 0.5F);
}

}  // namespace

bool isOpaque(const cv::Mat& picture) {
  double least = 0.0;
  cv::minMaxLoc(channel(picture, kAlpha), &least);
  return least == 255.0;
}

cv::Mat withoutAlpha(const cv::Mat& picture) {
  if (isOpaque(picture)) return picture;
  cv::Mat result = picture.clone();
  cv::insertChannel(cv::Mat(picture.size(), CV_8UC1, cv::Scalar(255)), result, kAlpha);
  return result;
}

bool isGrey(const cv::Mat& picture) {
  const cv::Mat red = channel(picture, kRed);
  return cv::norm(red, channel(picture, 0), cv::NORM_INF) == 0.0 &&
         cv::norm(red, channel(picture, 1), cv::NORM_INF) == 0.0;
}

cv::Mat redAsGrey(const cv::Mat& picture) { return fromGrey(channel(picture, kRed)); }

cv::Mat invertedRedAsGrey(const cv::Mat& picture) {
  cv::Mat inverted;
  cv::bitwise_not(channel(picture, kRed), inverted);
  return fromGrey(inverted);
}

cv::Mat greyAsAlpha(const cv::Mat& picture) {
  cv::Mat result(picture.size(), CV_8UC4, cv::Scalar::all(255));
  cv::insertChannel(isOpaque(picture) ? grey(picture) : channel(picture, kAlpha), result, kAlpha);
  return result;
}

cv::Mat withAlphaOf(const cv::Mat& picture, const cv::Mat& alpha) {
  cv::Mat values = channel(alpha, kAlpha);
  if (values.size() != picture.size()) cv::resize(values, values, picture.size());
  cv::Mat result = picture.clone();
  cv::insertChannel(values, result, kAlpha);
  return result;
}

cv::Mat normalsOfHeights(const cv::Mat& picture) {
  const cv::Mat heights = grey(picture);
  const int rows = heights.rows;
  const int columns = heights.cols;
  cv::Mat normals(heights.size(), CV_8UC4);
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const auto height = [&](int dx, int dy) {
        return static_cast<float>(
                   heights.at<std::uint8_t>((y + dy + rows) % rows, (x + dx + columns) % columns)) /
               255.0F;
      };
      const float right = kBumpDepth * 0.5F * (height(1, 0) - height(-1, 0));
      const float up = kBumpDepth * 0.5F * (height(0, -1) - height(0, 1));
      const Eigen::Vector3f n = Eigen::Vector3f(-right, -up, 1.0F).normalized();
      normals.at<cv::Vec4b>(y, x) = cv::Vec4b(encoded(n.z()), encoded(n.y()), encoded(n.x()), 255);
    }
  }
  return normals;
}

}  // namespace synthetic_dataset::base

#include "render/pixels/hull_pixels.h"

#include <algorithm>
#include <cmath>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace synthetic_dataset::render {

cv::Rect pixelsOfHull(const std::vector<Eigen::Vector3d>& points_W, const View& view) {
  constexpr double kSlack = 2.0;  // [px]
  std::vector<Eigen::Vector3d> points_C;
  const Pose X_CW = view.X_WC.inverse();
  for (const Eigen::Vector3d& point : points_W) points_C.push_back(X_CW * point);
  const auto box = view.camera.projectedBounds(points_C);
  if (!box) return {};
  const auto pixel = [](double place, int size) {
    return static_cast<int>(std::clamp(place, 0.0, static_cast<double>(size)));
  };
  const int width = view.camera.width();
  const int height = view.camera.height();
  return {cv::Point(pixel(std::floor(box->left - kSlack), width),
                    pixel(std::floor(box->top - kSlack), height)),
          cv::Point(pixel(std::ceil(box->right + kSlack), width),
                    pixel(std::ceil(box->bottom + kSlack), height))};
}

void markHull(const std::vector<Eigen::Vector3d>& points_W, const View& view, cv::Mat& pixels) {
  constexpr int kSlack = 5;  // [px] width of the line along the outline, so half of it is outside
  constexpr int kBits = 4;   // for fractions of a pixel
  constexpr double kFar = 1e6;  // [px]; OpenCV uses 32-bit integers
  const Pose X_CW = view.X_WC.inverse();
  std::vector<cv::Point> points;
  for (const Eigen::Vector3d& point : points_W) {
    const auto place = view.camera.project(X_CW * point);
    if (!place || place->cwiseAbs().maxCoeff() > kFar) {
      // The hull's outline is not that of its projected corners.
      const cv::Rect box = pixelsOfHull(points_W, view);
      if (!box.empty()) pixels(box).setTo(255);
      return;
    }
    const Eigen::Vector2d scaled = *place * (1 << kBits);
    points.emplace_back(static_cast<int>(scaled.x()), static_cast<int>(scaled.y()));
  }
  std::vector<cv::Point> outline;
  cv::convexHull(points, outline);
  cv::fillConvexPoly(pixels, outline, cv::Scalar(255), cv::LINE_8, kBits);
  cv::polylines(pixels, outline, true, cv::Scalar(255), kSlack, cv::LINE_8, kBits);
}

}  // namespace synthetic_dataset::render

#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::run {

/// A picture on which things are drawn as seen from straight above, in metres: x to the right, y
/// up.
class MapPaper {
 public:
  /// @param extent  that is shown [m]; not empty
  explicit MapPaper(const Eigen::AlignedBox2d& extent);

  [[nodiscard]] const Eigen::AlignedBox2d& extent() const { return extent_; }

  void fill(const std::vector<Eigen::Vector3d>& polygon, const cv::Scalar& ink);

  /// The same, so that what is below shows through.
  void shade(const std::vector<Eigen::Vector3d>& polygon, const cv::Scalar& ink);

  void line(const std::vector<Eigen::Vector3d>& points, const cv::Scalar& ink);
  void dot(const Eigen::Vector3d& point, const cv::Scalar& ink);

  /// A text beside a point, all of it on the paper; where another one is, further away with a line.
  void name(const std::string& text, const Eigen::Vector3d& point, const cv::Scalar& ink);

  /// Lines through whole multiples of the scale's length, with their coordinates.
  void grid();

  /// What is drawn, without anything else: CV_8UC3, as wide and high as the extent.
  [[nodiscard]] cv::Mat picture() const;

  /// The picture, CV_8UC3, with a scale and lines of text below it.
  [[nodiscard]] cv::Mat finish(const std::vector<std::string>& caption);

 private:
  [[nodiscard]] cv::Point at(const Eigen::Vector3d& point) const;
  [[nodiscard]] std::vector<cv::Point> at(const std::vector<Eigen::Vector3d>& points) const;

  Eigen::AlignedBox2d extent_;
  double scale_;  ///< [px/m]
  double step_;   ///< of the grid [m]: 1, 2 or 5 times a power of ten
  cv::Mat picture_;
  std::vector<cv::Rect> names_;  ///< where texts are
};

}  // namespace synthetic_dataset::run

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
  /// @param extent  the area shown [m]; not empty
  explicit MapPaper(const Eigen::AlignedBox2d& extent);

  [[nodiscard]] const Eigen::AlignedBox2d& extent() const { return extent_; }

  void fill(const std::vector<Eigen::Vector3d>& polygon, const cv::Scalar& ink);

  /// Fills a polygon with a translucent colour.
  void shade(const std::vector<Eigen::Vector3d>& polygon, const cv::Scalar& ink);

  void line(const std::vector<Eigen::Vector3d>& points, const cv::Scalar& ink);
  void dot(const Eigen::Vector3d& point, const cv::Scalar& ink);

  /// Writes a text beside a point, entirely on the paper; if another text is in the way, further
  /// off with a leader line.
  void name(const std::string& text, const Eigen::Vector3d& point, const cv::Scalar& ink);

  /// Draws grid lines at whole multiples of the scale's length, with their coordinates.
  void grid();

  /// The drawing without anything else: CV_8UC3, as wide and high as the extent.
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
  std::vector<cv::Rect> names_;  ///< areas that texts occupy
};

}  // namespace synthetic_dataset::run

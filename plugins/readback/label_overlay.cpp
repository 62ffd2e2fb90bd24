#include "plugins/readback/label_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <opencv2/imgproc.hpp>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/mask.h"

namespace synthetic_dataset::formats {
namespace {

/// Colours that colour-blind people can tell apart (Okabe and Ito 2008), blue green red.
const std::array<cv::Scalar, 6> kColours = {cv::Scalar(233, 180, 86),  cv::Scalar(115, 158, 0),
                                            cv::Scalar(167, 121, 204), cv::Scalar(66, 228, 240),
                                            cv::Scalar(0, 159, 230),   cv::Scalar(0, 94, 213)};
const cv::Scalar kBoxColour(240, 240, 240);
const cv::Scalar kDark(20, 20, 20);

constexpr int kSubpixelBits = 4;  // OpenCV draws at fractions of a pixel in shifted coordinates

/// A point in fixed-point coordinates, limited to the picture's surroundings; NaN is far away as
/// well.
cv::Point shifted(double u, double v) {
  constexpr double kScale = 1 << kSubpixelBits;
  constexpr double kFarthest = 1 << 16;  // [px]
  const auto place = [](double coordinate) {
    const bool is_near = std::abs(coordinate) < kFarthest;
    return cvRound((is_near ? coordinate : std::copysign(kFarthest, coordinate)) * kScale);
  };
  return {place(u), place(v)};
}

void tint(cv::Mat& image, const cv::Mat& mask, const cv::Scalar& colour) {
  constexpr double kStrength = 0.25;  // the picture below has to remain visible
  cv::Mat tinted;
  cv::addWeighted(image, 1.0 - kStrength, cv::Mat(image.size(), image.type(), colour), kStrength,
                  0.0, tinted);
  tinted.copyTo(image, mask);
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(mask, outlines, cv::RETR_LIST, cv::CHAIN_APPROX_NONE);
  cv::drawContours(image, outlines, -1, colour, 1);
}

void dot(cv::Mat& image, const cv::Point2d& place, const cv::Scalar& colour, int thickness) {
  cv::circle(image, shifted(place.x, place.y), 3 << kSubpixelBits, kDark, cv::FILLED, cv::LINE_AA,
             kSubpixelBits);
  cv::circle(image, shifted(place.x, place.y), 2 << kSubpixelBits, colour, thickness, cv::LINE_AA,
             kSubpixelBits);
}

void outline(cv::Mat& image, const Box& box) {
  cv::rectangle(image, shifted(box.left, box.top), shifted(box.right, box.bottom), kBoxColour, 1,
                cv::LINE_AA, kSubpixelBits);
}

void outline(cv::Mat& image, const std::vector<cv::Point2d>& polygon, const cv::Scalar& colour) {
  std::vector<cv::Point> points;
  for (const cv::Point2d& point : polygon) points.push_back(shifted(point.x, point.y));
  cv::polylines(image, points, true, colour, 1, cv::LINE_AA, kSubpixelBits);
}

/// Whether a polygon is a mask's: boxes have four corners.
bool isOutline(const std::vector<cv::Point2d>& polygon) { return polygon.size() > 4; }

cv::Mat filled(const std::vector<cv::Point2d>& polygon, const cv::Size& size) {
  std::vector<cv::Point> points;
  for (const cv::Point2d& point : polygon) points.push_back(shifted(point.x, point.y));
  cv::Mat mask = cv::Mat::zeros(size, CV_8UC1);
  cv::fillPoly(mask, std::vector<std::vector<cv::Point>>{points}, cv::Scalar::all(255), cv::LINE_8,
               kSubpixelBits);
  return mask;
}

/// The box around everything that a label shows; nothing if it shows nothing.
std::optional<Box> extentOf(const DrawnLabel& label) {
  if (label.box) return *label.box;
  if (!label.mask.empty()) return boxAround(maskBounds(label.mask));
  std::vector<cv::Point2d> points = label.keypoints;
  for (const auto& polygon : label.polygons) {
    points.insert(points.end(), polygon.begin(), polygon.end());
  }
  for (const auto& line : label.lines) points.insert(points.end(), line.begin(), line.end());
  if (points.empty()) return std::nullopt;
  Box box{points[0].x, points[0].y, points[0].x, points[0].y};
  for (const cv::Point2d& point : points) {
    box = {std::min(box.left, point.x), std::min(box.top, point.y), std::max(box.right, point.x),
           std::max(box.bottom, point.y)};
  }
  return box;
}

void write(cv::Mat& image, const std::string& caption, const Box& extent) {
  constexpr double kSize = 0.42;
  int baseline = 0;
  const cv::Size text = cv::getTextSize(caption, cv::FONT_HERSHEY_SIMPLEX, kSize, 1, &baseline);
  const auto between = [](double value, int low, int high) {  // the caption may not fit
    const double bounded = std::min(std::max(value, static_cast<double>(low)), 1.0 * high);
    return std::isnan(value) ? low : cvRound(bounded);
  };
  const int left = between(extent.left, 0, std::max(0, image.cols - text.width - 5));
  const int bottom =
      between(extent.top - 3, text.height + 3, std::max(text.height + 3, image.rows - 5));
  const cv::Point corner(left, bottom);
  cv::rectangle(image, corner + cv::Point(-1, 4),
                corner + cv::Point(text.width + 4, -text.height - 3), kBoxColour, cv::FILLED);
  cv::putText(image, caption, corner + cv::Point(2, 0), cv::FONT_HERSHEY_SIMPLEX, kSize, kDark, 1,
              cv::LINE_AA);
}

void checkMask(const DrawnLabel& label, const cv::Size& size) {
  if (label.mask.empty() || (label.mask.type() == CV_8UC1 && label.mask.size() == size)) return;
  throw Error("a mask of '" + label.caption + "' has " + std::to_string(label.mask.cols) + " x " +
              std::to_string(label.mask.rows) + " pixels; its image has " +
              std::to_string(size.width) + " x " + std::to_string(size.height));
}

}  // namespace

cv::Scalar labelColour(std::size_t number) { return kColours[number % kColours.size()]; }

cv::Mat drawLabels(const LabelledPicture& picture) {
  for (const DrawnLabel& label : picture.labels) checkMask(label, picture.image.size());
  cv::Mat result = picture.image.clone();
  const std::vector<DrawnLabel>& labels = picture.labels;
  const auto colourOf = [&](std::size_t i) { return labelColour(labels[i].colour.value_or(i)); };
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!labels[i].mask.empty()) tint(result, labels[i].mask, colourOf(i));
    for (const auto& polygon : labels[i].polygons) {
      if (isOutline(polygon)) tint(result, filled(polygon, result.size()), colourOf(i));
      outline(result, polygon, colourOf(i));
    }
  }
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i].box) outline(result, *labels[i].box);
    for (const auto& [from, to] : labels[i].lines) {
      cv::line(result, shifted(from.x, from.y), shifted(to.x, to.y), colourOf(i), 1, cv::LINE_AA,
               kSubpixelBits);
    }
  }
  constexpr double kLineHeight = 20.0;  // [px]
  double next_line = kLineHeight;       // for captions of labels that show nothing
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (const cv::Point2d& point : labels[i].keypoints) {
      dot(result, point, colourOf(i), cv::FILLED);
    }
    for (const cv::Point2d& point : labels[i].hidden_keypoints) dot(result, point, colourOf(i), 1);
    if (labels[i].caption.empty()) continue;
    const std::optional<Box> extent = extentOf(labels[i]);
    write(result, labels[i].caption, extent.value_or(Box{0.0, next_line, 0.0, next_line}));
    if (!extent) next_line += kLineHeight;
  }
  return result;
}

}  // namespace synthetic_dataset::formats

#include "plugins/readback/mask_shapes.h"

#include <algorithm>
#include <cstdlib>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "plugins/readback/json_file.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats {
namespace {

/// A corner between pixels.
cv::Point cornerAt(const nlohmann::json& numbers, std::size_t i, const cv::Size& size) {
  const nlohmann::json& x = numbers.at(2 * i);
  const nlohmann::json& y = numbers.at(2 * i + 1);
  const auto isWithin = [](const nlohmann::json& number, int most) {
    return number.is_number_integer() && number >= 0 && number <= most;
  };
  if (!isWithin(x, size.width) || !isWithin(y, size.height)) {
    throw Error("found the corner [" + x.dump() + ", " + y.dump() +
                "] of a polygon; it should be one between pixels of the image");
  }
  return {x.get<int>(), y.get<int>()};
}

/// Turns over, in rows between two corners, all pixels right of an edge.
void turnOver(cv::Mat& parity, const cv::Point& from, const cv::Point& to) {
  for (int row = std::min(from.y, to.y); row < std::max(from.y, to.y); ++row) {
    parity.at<uchar>(row, from.x) ^= 1U;
  }
}

}  // namespace

cv::Mat maskOfEdges(const nlohmann::json& polygons, const cv::Size& size) {
  cv::Mat mask = cv::Mat::zeros(size, CV_8UC1);
  for (const nlohmann::json& numbers : polygons) {
    if (numbers.size() % 2 != 0) throw Error("found a polygon with half a corner");
    cv::Mat parity = cv::Mat::zeros(size.height, size.width + 1, CV_8UC1);
    const std::size_t count = numbers.size() / 2;
    for (std::size_t i = 0; i < count; ++i) {
      const cv::Point from = cornerAt(numbers, i, size);
      const cv::Point to = cornerAt(numbers, (i + 1) % count, size);
      if (from.x != to.x && from.y != to.y) {
        throw Error("found a polygon with a slanted edge; its edges should be those of pixels");
      }
      if (from.x == to.x) turnOver(parity, from, to);
    }
    for (int row = 0; row < size.height; ++row) {
      uchar is_inside = 0;
      for (int column = 0; column < size.width; ++column) {
        is_inside = static_cast<uchar>(is_inside ^ parity.at<uchar>(row, column));
        if (is_inside == 0) continue;
        if (mask.at<uchar>(row, column) != 0) throw Error("found polygons that overlap");
        mask.at<uchar>(row, column) = 255;
      }
    }
  }
  return mask;
}

std::string outlineProblem(const std::vector<cv::Point>& outline, const Mask& mask) {
  const cv::Mat right = mask.whole();
  cv::Mat filled = cv::Mat::zeros(right.size(), CV_8UC1);
  cv::fillPoly(filled, std::vector<std::vector<cv::Point>>{outline}, cv::Scalar::all(255));
  cv::Mat wrong;
  cv::bitwise_and(right, ~filled, wrong);
  if (cv::countNonZero(wrong) > 0) {
    return "found a polygon that lacks " + std::to_string(cv::countNonZero(wrong)) +
           " pixels of the mask";
  }
  // What it has more are bridges: each a straight line between two of the mask's pixels.
  cv::bitwise_and(filled, ~right, wrong);
  if (cv::countNonZero(wrong) == 0) return "";
  cv::Mat parts;
  const int part_count = cv::connectedComponents(mask.pixels(), parts) - 1;
  for (std::size_t i = 0; i < outline.size() && part_count > 1; ++i) {
    const cv::Point& from = outline[i];
    const cv::Point& to = outline[(i + 1) % outline.size()];
    if (mask.at(from) && mask.at(to)) cv::line(wrong, from, to, cv::Scalar::all(0));
  }
  if (cv::countNonZero(wrong) == 0) return "";
  return "found a polygon with " + std::to_string(cv::countNonZero(wrong)) +
         " pixels that are not of the mask";
}

std::string outlineProblem(const nlohmann::json& points, const Mask& mask) {
  std::vector<cv::Point> outline;
  for (const nlohmann::json& point : points) {
    if (point.size() != 2) return "found the point " + point.dump() + "; it should be [x, y]";
    outline.emplace_back(integerOf(point.at(0)), integerOf(point.at(1)));
    if (!cv::Rect({}, mask.imageSize()).contains(outline.back())) {
      return "found the point " + point.dump() + "; it should be a pixel of the image";
    }
  }
  return outlineProblem(outline, mask);
}

}  // namespace synthetic_dataset::formats

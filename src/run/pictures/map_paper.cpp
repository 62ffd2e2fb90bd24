#include "run/pictures/map_paper.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <opencv2/imgproc.hpp>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::run {
namespace {

constexpr int kLongSide = 1100;  // [px]
constexpr int kFooter = 76;      // [px]
constexpr int kMapFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kMapFontScale = 0.45;
const cv::Scalar kMapPaper(250, 250, 250);
const cv::Scalar kGridInk(205, 205, 205);
const cv::Scalar kTextInk(40, 40, 40);

/// The largest of ..., 1, 2, 5, 10, ... that does not exceed a length.
double roundLength(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= length) return factor * power;
  }
  return power;
}

std::string numberText(double number, double step) {
  return fixed(number + 0.0, step < 1.0 ? static_cast<int>(std::ceil(-std::log10(step))) : 0);
}

}  // namespace

MapPaper::MapPaper(const Eigen::AlignedBox2d& extent)
    : extent_(extent),
      scale_(kLongSide / std::max(extent.sizes().maxCoeff(), 1e-3)),
      step_(roundLength(0.2 * extent.sizes().maxCoeff())) {
  const auto pixels = [&](double length) {
    return std::max(440, static_cast<int>(std::ceil(length * scale_)));
  };
  picture_ =
      cv::Mat(pixels(extent.sizes().y()) + kFooter, pixels(extent.sizes().x()), CV_8UC3, kMapPaper);
}

cv::Point MapPaper::at(const Eigen::Vector3d& point) const {
  constexpr double kFarthest = 1e4;  // [px]
  const auto pixel = [&](double place) {
    return cvRound(std::clamp(place, -kFarthest, kFarthest));
  };
  return {pixel((point.x() - extent_.min().x()) * scale_),
          pixel((extent_.max().y() - point.y()) * scale_)};
}

std::vector<cv::Point> MapPaper::at(const std::vector<Eigen::Vector3d>& points) const {
  std::vector<cv::Point> pixels;
  for (const Eigen::Vector3d& point : points) pixels.push_back(at(point));
  return pixels;
}

void MapPaper::fill(const std::vector<Eigen::Vector3d>& polygon, const cv::Scalar& ink) {
  cv::fillConvexPoly(picture_, at(polygon), ink);
}

void MapPaper::shade(const std::vector<Eigen::Vector3d>& polygon, const cv::Scalar& ink) {
  if (polygon.size() < 3) return;
  constexpr double kStrength = 0.13;
  std::vector<cv::Point> hull;
  cv::convexHull(at(polygon), hull);
  cv::Mat shaded = picture_.clone();
  cv::fillConvexPoly(shaded, hull, ink);
  cv::addWeighted(shaded, kStrength, picture_, 1.0 - kStrength, 0.0, picture_);
  cv::polylines(picture_, std::vector<std::vector<cv::Point>>{hull}, true, ink, 1, cv::LINE_AA);
}

void MapPaper::line(const std::vector<Eigen::Vector3d>& points, const cv::Scalar& ink) {
  cv::polylines(picture_, std::vector<std::vector<cv::Point>>{at(points)}, false, ink, 2,
                cv::LINE_AA);
}

void MapPaper::dot(const Eigen::Vector3d& point, const cv::Scalar& ink) {
  cv::circle(picture_, at(point), 4, ink, cv::FILLED, cv::LINE_AA);
}

void MapPaper::name(const std::string& text, const Eigen::Vector3d& point, const cv::Scalar& ink) {
  int below = 0;
  const cv::Size size = cv::getTextSize(text, kMapFont, kMapFontScale, 1, &below);
  cv::Point corner = at(point) + cv::Point(8, -6);
  corner.x = std::clamp(corner.x, 2, std::max(2, picture_.cols - size.width - 2));
  corner.y = std::clamp(corner.y, size.height + 2, picture_.rows - kFooter - 4);
  const auto around = [&](const cv::Point& at) {
    return cv::Rect(at + cv::Point(-2, -size.height - 2), at + cv::Point(size.width + 2, below));
  };
  const auto isFree = [&](const cv::Point& at) {
    const cv::Rect wanted = around(at);
    const bool is_inside = wanted.y >= 0 && wanted.br().y <= picture_.rows - kFooter;
    return is_inside && std::none_of(names_.begin(), names_.end(), [&](const cv::Rect& other) {
             return (wanted & other).area() > 0;
           });
  };
  constexpr int kMostSteps = 12;
  const int step = size.height + below + 5;
  cv::Point free = corner;
  for (int i = 1; i <= 2 * kMostSteps && !isFree(free); ++i) {  // below, above, further below, ...
    free.y = corner.y + (i % 2 == 1 ? 1 : -1) * ((i + 1) / 2) * step;
  }
  if (!isFree(free)) free = corner;
  if (std::abs(free.y - corner.y) > step) {
    cv::line(picture_, at(point), free + cv::Point(-2, -size.height / 2), ink, 1, cv::LINE_AA);
  }
  corner = free;
  names_.push_back(around(corner));
  cv::rectangle(picture_, names_.back(), kMapPaper, cv::FILLED);
  cv::putText(picture_, text, corner, kMapFont, kMapFontScale, ink, 1, cv::LINE_AA);
}

void MapPaper::grid() {
  const int bottom = picture_.rows - kFooter;
  const auto write = [&](const std::string& text, const cv::Point& corner) {
    cv::putText(picture_, text, corner, kMapFont, 0.38, kTextInk, 1, cv::LINE_AA);
  };
  for (double x = std::ceil(extent_.min().x() / step_) * step_; x <= extent_.max().x();
       x += step_) {
    const int u = at({x, 0, 0}).x;
    cv::line(picture_, {u, 0}, {u, bottom}, kGridInk, 1);
    write(numberText(x, step_), {u + 3, bottom - 4});
  }
  for (double y = std::ceil(extent_.min().y() / step_) * step_; y <= extent_.max().y();
       y += step_) {
    const int v = at({0, y, 0}).y;
    cv::line(picture_, {0, v}, {picture_.cols, v}, kGridInk, 1);
    write(numberText(y, step_), {3, v - 3});
  }
}

cv::Mat MapPaper::picture() const {
  const Eigen::Vector2d size = (extent_.sizes() * scale_).array().round().max(1.0);
  const cv::Rect drawn(0, 0, static_cast<int>(size.x()), static_cast<int>(size.y()));
  return picture_(drawn & cv::Rect(0, 0, picture_.cols, picture_.rows - kFooter)).clone();
}

cv::Mat MapPaper::finish(const std::vector<std::string>& caption) {
  const int top = picture_.rows - kFooter;
  cv::rectangle(picture_, {0, top}, {picture_.cols, picture_.rows}, kMapPaper, cv::FILLED);
  const int length = cvRound(step_ * scale_);
  const cv::Point left(12, top + 20);
  cv::line(picture_, left, left + cv::Point(length, 0), kTextInk, 2);
  for (const int x : {0, length}) {
    cv::line(picture_, left + cv::Point(x, -5), left + cv::Point(x, 5), kTextInk, 2);
  }
  cv::putText(picture_, numberText(step_, step_) + " m", left + cv::Point(length + 8, 5), kMapFont,
              kMapFontScale, kTextInk, 1, cv::LINE_AA);
  int y = top + 46;
  for (const std::string& line : caption) {
    cv::putText(picture_, line, {12, y}, kMapFont, 0.4, kTextInk, 1, cv::LINE_AA);
    y += 18;
  }
  return picture_;
}

}  // namespace synthetic_dataset::run

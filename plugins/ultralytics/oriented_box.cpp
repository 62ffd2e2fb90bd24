#include "plugins/ultralytics/oriented_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace synthetic_dataset {
namespace {

using Polygon = std::vector<Eigen::Vector2d>;

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  [[nodiscard]] double length() const { return std::max(0.0, high - low); }
};

/// A rectangle along the unit vectors u and v, v a quarter turn clockwise from u on the screen.
struct Rectangle {
  Eigen::Vector2d u = Eigen::Vector2d::UnitX();
  Range along_u;
  Range along_v;

  [[nodiscard]] Eigen::Vector2d v() const { return {-u.y(), u.x()}; }
  [[nodiscard]] double area() const { return along_u.length() * along_v.length(); }
};

/// The convex hull of the corners of all pixels, in integer coordinates.
Polygon hullOf(const Mask& mask) {
  std::vector<cv::Point> corners;
  const cv::Mat& part = mask.pixels();
  for (int row = 0; row < part.rows; ++row) {
    const uchar* pixels = part.ptr(row);
    const uchar* end = pixels + part.cols;
    const uchar* first = std::find_if(pixels, end, [](uchar pixel) { return pixel != 0; });
    if (first == end) continue;
    while (*(end - 1) == 0) --end;
    const int left = mask.offset().x + static_cast<int>(first - pixels);
    const int right = mask.offset().x + static_cast<int>(end - pixels);
    const int top = mask.offset().y + row;
    corners.insert(corners.end(), {{left, top}, {left, top + 1}, {right, top}, {right, top + 1}});
  }
  if (corners.empty()) return {};
  std::vector<cv::Point> hull;
  cv::convexHull(corners, hull);
  Polygon polygon;
  for (const cv::Point& corner : hull) polygon.emplace_back(corner.x, corner.y);
  return polygon;
}

double areaOf(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    twice += a.x() * b.y() - b.x() * a.y();
  }
  return 0.5 * std::abs(twice);
}

/// The part of a convex polygon where `direction` . p <= `limit`.
Polygon clipped(const Polygon& polygon, const Eigen::Vector2d& direction, double limit) {
  Polygon part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    const double beyond_a = direction.dot(a) - limit;
    const double beyond_b = direction.dot(b) - limit;
    if (beyond_a <= 0.0) part.push_back(a);
    if ((beyond_a < 0.0 && beyond_b > 0.0) || (beyond_a > 0.0 && beyond_b < 0.0)) {
      part.push_back(a + beyond_a / (beyond_a - beyond_b) * (b - a));
    }
  }
  return part;
}

Rectangle enclosing(const Polygon& hull, const Eigen::Vector2d& u) {
  Rectangle rectangle;
  rectangle.u = u;
  for (const Eigen::Vector2d& corner : hull) {
    const double at_u = corner.dot(u);
    const double at_v = corner.dot(rectangle.v());
    rectangle.along_u = {std::min(rectangle.along_u.low, at_u),
                         std::max(rectangle.along_u.high, at_u)};
    rectangle.along_v = {std::min(rectangle.along_v.low, at_v),
                         std::max(rectangle.along_v.high, at_v)};
  }
  return rectangle;
}

/// The part of the given range of t for which `origin` + t `direction` is in the image.
Range partInImage(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction, Range range,
                  const Eigen::Vector2d& image) {
  for (int axis = 0; axis < 2; ++axis) {
    if (direction[axis] == 0.0) {
      if (origin[axis] < 0.0 || origin[axis] > image[axis]) return {};
      continue;
    }
    double enters = -origin[axis] / direction[axis];
    double leaves = (image[axis] - origin[axis]) / direction[axis];
    if (enters > leaves) std::swap(enters, leaves);
    range = {std::max(range.low, enters), std::min(range.high, leaves)};
  }
  return range;
}

/// Shortens the rectangle along u until its corners are in the image.
Rectangle cutAlongU(Rectangle rectangle, const Eigen::Vector2d& image) {
  for (const double v : {rectangle.along_v.low, rectangle.along_v.high}) {
    rectangle.along_u = partInImage(v * rectangle.v(), rectangle.u, rectangle.along_u, image);
  }
  return rectangle;
}

Rectangle cutAlongV(Rectangle rectangle, const Eigen::Vector2d& image) {
  for (const double u : {rectangle.along_u.low, rectangle.along_u.high}) {
    rectangle.along_v = partInImage(u * rectangle.u, rectangle.v(), rectangle.along_v, image);
  }
  return rectangle;
}

/// Whether the mask has pixels at the image's edge.
bool leavesImage(const Polygon& hull, const Eigen::Vector2d& image) {
  return std::any_of(hull.begin(), hull.end(), [&](const Eigen::Vector2d& corner) {
    return corner.minCoeff() <= 0.0 || (image - corner).minCoeff() <= 0.0;
  });
}

struct Fit {
  Rectangle rectangle;
  double overlap = 0.0;  ///< with the hull: intersection over union
};

Fit fitOf(const Rectangle& rectangle, const Polygon& hull) {
  if (rectangle.area() <= 0.0) return {};  // nothing is left of it
  const Eigen::Vector2d u = rectangle.u;
  const Eigen::Vector2d v = rectangle.v();
  Polygon common = clipped(hull, u, rectangle.along_u.high);
  common = clipped(common, -u, -rectangle.along_u.low);
  common = clipped(common, v, rectangle.along_v.high);
  common = clipped(common, -v, -rectangle.along_v.low);
  const double common_area = areaOf(common);
  return {rectangle, common_area / (rectangle.area() + areaOf(hull) - common_area)};
}

std::array<Eigen::Vector2d, 4> cornersOf(const Rectangle& rectangle, const Eigen::Vector2d& image) {
  const auto corner = [&](double u, double v) -> Eigen::Vector2d {
    const Eigen::Vector2d place = u * rectangle.u + v * rectangle.v();
    return place.cwiseMax(0.0).cwiseMin(image);  // only rounding leads outside
  };
  const Range& u = rectangle.along_u;
  const Range& v = rectangle.along_v;
  return {corner(u.low, v.low), corner(u.high, v.low), corner(u.high, v.high),
          corner(u.low, v.high)};
}

}  // namespace

std::optional<std::array<Eigen::Vector2d, 4>> orientedBox(const Mask& mask) {
  const Polygon hull = hullOf(mask);
  if (hull.empty()) return std::nullopt;
  const Eigen::Vector2d image(mask.imageSize().width, mask.imageSize().height);

  // The rectangle along the image's edges is within the image, since the mask is.
  Fit whole = fitOf(enclosing(hull, Eigen::Vector2d::UnitX()), hull);
  Fit cut;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d edge = hull[(i + 1) % hull.size()] - hull[i];
    const Rectangle rectangle = enclosing(hull, edge.normalized());
    for (const Rectangle& part : {cutAlongU(rectangle, image), cutAlongV(rectangle, image)}) {
      constexpr double kRounding = 1e-9;
      const bool is_whole = part.area() >= rectangle.area() * (1.0 - kRounding);
      Fit& best = is_whole ? whole : cut;
      const Fit fit = fitOf(part, hull);
      if (fit.overlap > best.overlap + kRounding) best = fit;
    }
  }
  constexpr double kWorthCutting = 1.25;
  const bool is_cut = leavesImage(hull, image) && cut.overlap > kWorthCutting * whole.overlap;
  return cornersOf(is_cut ? cut.rectangle : whole.rectangle, image);
}

}  // namespace synthetic_dataset

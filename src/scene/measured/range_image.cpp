#include "scene/measured/range_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <opencv2/imgproc.hpp>

namespace synthetic_dataset::scene {
namespace {

/// How far something reaches around a position in the image [px].
struct Reach {
  double left = 0.0;
  double right = 0.0;
  double up = 0.0;
  double down = 0.0;
};

/// Draws into all pixels whose centres are within the reach; nearer ranges stay.
void draw(const Eigen::Vector2d& pixel, const Reach& reach, double range, cv::Mat_<float>& ranges) {
  const int left = std::max(0, static_cast<int>(std::ceil(pixel.x() - reach.left)));
  const int right =
      std::min(ranges.cols - 1, static_cast<int>(std::floor(pixel.x() + reach.right)));
  const int top = std::max(0, static_cast<int>(std::ceil(pixel.y() - reach.up)));
  const int bottom =
      std::min(ranges.rows - 1, static_cast<int>(std::floor(pixel.y() + reach.down)));
  const auto value = static_cast<float>(range);
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      float& there = ranges(y, x);
      if (there == 0.0F || value < there) there = value;
    }
  }
}

bool isInside(const Eigen::Vector2d& pixel, const CameraModel& camera) {
  return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < camera.width() - 0.5 &&
         pixel.y() < camera.height() - 0.5;
}

/// A point of a cloud, in the image.
struct SeenPoint {
  Eigen::Vector2d pixel;
  double range = 0.0;
};

constexpr std::size_t kSides = 4;
constexpr int kNothing = 0;  // no neighbour

/// Distance to the next point of the same surface on each side of a point [px], within the quadrant
/// that opens there: right, left, down, up.
using Spacing = std::array<int, kSides>;

class PointNeighbours {
 public:
  PointNeighbours(const std::vector<SeenPoint>& points, const cv::Size& size) {
    ranges_ = cv::Mat_<float>(size, 0.0F);
    for (const SeenPoint& each : points) {
      float& there = ranges_(pixelOf(each));
      const auto range = static_cast<float>(each.range);
      if (there == 0.0F || range < there) there = range;
    }
    cv::integral(ranges_ > 0.0F, sums_, CV_32S);
    constexpr int kFarthest = 8;  // fraction of the image's longer side: 1/8
    farthest_ = std::max(size.width, size.height) / kFarthest;
  }

  static cv::Point pixelOf(const SeenPoint& point) {
    return {static_cast<int>(std::lround(point.pixel.x())),
            static_cast<int>(std::lround(point.pixel.y()))};
  }

  [[nodiscard]] Spacing of(const SeenPoint& point) const {
    const cv::Point at = pixelOf(point);
    Spacing spacing{};
    for (std::size_t side = 0; side < kSides; ++side) {
      for (int k = 1; k <= farthest_ && spacing[side] == kNothing; ++k) {
        if (hasPoint(strip(at, side, k), point.range)) spacing[side] = k;
      }
    }
    return spacing;
  }

 private:
  /// The pixels at distance `k` on a side.
  static cv::Rect strip(const cv::Point& at, std::size_t side, int k) {
    const bool is_across = side < 2;
    const int step = side % 2 == 0 ? k : -k;
    const int length = 2 * k + 1;
    return is_across ? cv::Rect(at.x + step, at.y - k, 1, length)
                     : cv::Rect(at.x - k, at.y + step, length, 1);
  }

  /// Whether the strip has a point at about this range: points behind a surface, seen from
  /// elsewhere, show between the surface's own points.
  [[nodiscard]] bool hasPoint(const cv::Rect& strip, double range) const {
    constexpr double kStep = 0.15;  // between points of a surface, as a fraction of the range
    const cv::Rect r = strip & cv::Rect({0, 0}, ranges_.size());
    if (r.empty()) return false;
    if (sums_(r.br()) - sums_(r.y, r.br().x) - sums_(r.br().y, r.x) + sums_(r.tl()) == 0) {
      return false;
    }
    const cv::Mat_<float> found = ranges_(r);
    return std::any_of(found.begin(), found.end(), [&](float each) {
      return each > 0.0F && std::abs(each - range) <= kStep * range;
    });
  }

  cv::Mat_<float> ranges_;  ///< of the points
  cv::Mat_<int> sums_;
  int farthest_ = 0;  ///< [px]
};

/// The median of the known spacings on two opposite sides [px]; 0 if there are none.
double usualSpacing(const std::vector<Spacing>& all, std::size_t first_side) {
  std::vector<int> known;
  for (const Spacing& each : all) {
    for (const std::size_t side : {first_side, first_side + 1}) {
      if (each[side] != kNothing) known.push_back(each[side]);
    }
  }
  if (known.empty()) return 0.0;
  const auto middle = known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2);
  std::nth_element(known.begin(), middle, known.end());
  return *middle;
}

double reachOn(int spacing, double usual) {
  constexpr double kWidest = 1.5;    // times the usual spacing
  constexpr double kRounding = 0.5;  // of a spacing in whole pixels [px]
  const double known = spacing == kNothing ? usual : std::min<double>(spacing, kWidest * usual);
  constexpr double kPixel = 1.0;  // least size of a point [px]
  return 0.5 * std::max(kPixel, known + kRounding);
}

}  // namespace

DepthLens::DepthLens(const CameraModel& camera) : camera_(camera) {
  rays_.reserve(static_cast<std::size_t>(camera.width()) *
                static_cast<std::size_t>(camera.height()));
  for (int y = 0; y < camera.height(); ++y) {
    for (int x = 0; x < camera.width(); ++x) {
      const auto ray = camera.ray({static_cast<double>(x), static_cast<double>(y)});
      const bool has_depth = ray && ray->z() > 0.0;
      rays_.push_back(has_depth ? Eigen::Vector3d(*ray / ray->z()) : Eigen::Vector3d(0, 0, 0));
    }
  }
}

cv::Mat rangesOfDepth(const cv::Mat& depth, const DepthLens& lens, const Pose& X_CD,
                      const CameraModel& camera) {
  constexpr double kClosing = 1.1;  // neighbours overlap slightly, so that slopes have no holes
  const double focal = std::max(camera.intrinsics().fx, camera.intrinsics().fy) /
                       std::min(lens.camera().intrinsics().fx, lens.camera().intrinsics().fy);
  cv::Mat_<float> ranges(camera.height(), camera.width(), 0.0F);
  std::size_t i = 0;
  for (int y = 0; y < depth.rows; ++y) {
    const auto* const row = depth.ptr<float>(y);
    for (int x = 0; x < depth.cols; ++x, ++i) {
      const Eigen::Vector3d& ray = lens.rays()[i];
      if (row[x] == 0.0F || ray.z() == 0.0) continue;
      const Eigen::Vector3d p_D = ray * double{row[x]};
      const Eigen::Vector3d p_C = X_CD * p_D;
      const auto pixel = camera.project(p_C);
      if (!pixel) continue;
      const double nearness = camera.hasNearPlane() ? p_D.z() / p_C.z() : p_D.norm() / p_C.norm();
      const double half = 0.5 * kClosing * focal * nearness;
      draw(*pixel, {half, half, half, half}, p_C.norm(), ranges);
    }
  }
  return std::move(ranges);
}

cv::Mat rangesOfCloud(const std::vector<Eigen::Vector3d>& points_C, const CameraModel& camera) {
  std::vector<SeenPoint> points;
  for (const Eigen::Vector3d& p_C : points_C) {
    const auto pixel = camera.project(p_C);
    if (pixel && isInside(*pixel, camera)) points.push_back({*pixel, p_C.norm()});
  }
  const cv::Size size(camera.width(), camera.height());
  const PointNeighbours neighbours(points, size);
  std::vector<Spacing> spacings;
  for (const SeenPoint& each : points) spacings.push_back(neighbours.of(each));
  const double across = usualSpacing(spacings, 0);
  const double along = usualSpacing(spacings, 2);
  cv::Mat_<float> ranges(size, 0.0F);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Spacing& s = spacings[i];
    const Reach reach{reachOn(s[1], across), reachOn(s[0], across), reachOn(s[3], along),
                      reachOn(s[2], along)};
    draw(points[i].pixel, reach, points[i].range, ranges);
  }
  return std::move(ranges);
}

cv::Mat nearestOf(const cv::Mat& first, const cv::Mat& second) {
  if (first.empty()) return second;
  if (second.empty()) return first;
  cv::Mat nearest = cv::min(first, second);
  second.copyTo(nearest, first == 0.0F);
  first.copyTo(nearest, second == 0.0F);
  return nearest;
}

}  // namespace synthetic_dataset::scene

#include "render/sensor/depth_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "base/random/random_seed.h"

namespace synthetic_dataset::render {
namespace {

constexpr std::uint64_t kDrawsADepth = 2;

/// The difference between neighbouring disparities from which on there is an edge [px].
constexpr double kEdge = 1.0;

/// A depth picture of a rectified camera.
class DepthView {
 public:
  DepthView(const cv::Mat& depth, const CameraModel& camera, double baseline)
      : depth_(depth), k_(camera.intrinsics()), focal_baseline_(k_.fx * baseline) {}

  [[nodiscard]] double depthAt(int u, int v) const { return depth_(v, u); }

  /// The disparity of a point at this depth [px].
  [[nodiscard]] double disparity(double depth) const { return focal_baseline_ / depth; }

  /// The depth that corresponds to a disparity once it is rounded; 0 for none.
  [[nodiscard]] double rounded(double disparity, double step) const {
    if (step > 0.0) disparity = std::round(disparity / step) * step;
    return disparity > 0.0 ? focal_baseline_ / disparity : 0.0;
  }

  /// The depth error per pixel of disparity error: z = fb/d.
  [[nodiscard]] double depthPerPixel(double depth) const { return depth * depth / focal_baseline_; }

  /// The angle between the ray and the normal of the surface that a pixel shows [rad].
  [[nodiscard]] double angleAt(int u, int v) const {
    const Eigen::Vector3d point = pointAt(u, v);
    const Eigen::Vector3d normal = alongAt(u, v, 1, 0).cross(alongAt(u, v, 0, 1));
    const double lengths = normal.norm() * point.norm();
    if (lengths == 0.0) return 0.0;  // the pixel has no neighbours
    return std::acos(std::min(std::abs(normal.dot(point)) / lengths, 1.0));
  }

  /// Whether a neighbour is much nearer or farther.
  [[nodiscard]] bool isBesideEdge(int u, int v) const {
    const double own = disparity(depthAt(u, v));
    for (const cv::Point& next : {cv::Point(u + 1, v), {u - 1, v}, {u, v + 1}, {u, v - 1}}) {
      if (!has(next.x, next.y)) continue;
      const double other = depthAt(next.x, next.y);
      if (std::abs((other > 0.0 ? disparity(other) : 0.0) - own) > kEdge) return true;
    }
    return false;
  }

  /// The pixels that the other view does not see: CV_8UC1, 255 for these. The point of pixel u lies
  /// at u - d in the other view; it is hidden if a pixel to the right of u lies there or farther
  /// left.
  [[nodiscard]] cv::Mat_<uchar> hidden() const {
    cv::Mat_<uchar> hidden(depth_.size());
    hidden = 0;
    for (int v = 0; v < depth_.rows; ++v) {
      double leftmost = std::numeric_limits<double>::infinity();
      for (int u = depth_.cols - 1; u >= 0; --u) {
        if (depthAt(u, v) <= 0.0) continue;
        const double place = u - disparity(depthAt(u, v));
        if (leftmost <= place) hidden(v, u) = 255;
        leftmost = std::min(leftmost, place);
      }
    }
    return hidden;
  }

 private:
  [[nodiscard]] bool has(int u, int v) const {
    return u >= 0 && v >= 0 && u < depth_.cols && v < depth_.rows;
  }

  [[nodiscard]] Eigen::Vector3d pointAt(int u, int v) const {
    return depthAt(u, v) * Eigen::Vector3d((u - k_.cx) / k_.fx, (v - k_.cy) / k_.fy, 1.0);
  }

  /// The vector between a pixel's point and that of the neighbour, on one side or the other, whose
  /// depth is closer to the pixel's; always in the direction of increasing u or v.
  [[nodiscard]] Eigen::Vector3d alongAt(int u, int v, int across, int down) const {
    const double own = depthAt(u, v);
    Eigen::Vector3d along = Eigen::Vector3d::Zero();
    double least = std::numeric_limits<double>::infinity();
    for (const int side : {1, -1}) {
      const int other_u = u + side * across;
      const int other_v = v + side * down;
      if (!has(other_u, other_v) || depthAt(other_u, other_v) <= 0.0) continue;
      const double step = std::abs(depthAt(other_u, other_v) - own);
      if (step >= least) continue;
      least = step;
      along = side * (pointAt(other_u, other_v) - pointAt(u, v));
    }
    return along;
  }

  cv::Mat_<float> depth_;
  Intrinsics k_;
  double focal_baseline_;  ///< [px m]
};

std::uint64_t depthPlace(int u, int v, const cv::Mat& picture) {
  return (static_cast<std::uint64_t>(v) * static_cast<std::uint64_t>(picture.cols) +
          static_cast<std::uint64_t>(u)) *
         kDrawsADepth;
}

/// The standard deviation of the error from rounding to a step.
double ofRounding(double step) { return step / std::sqrt(12.0); }

/// Measures the pixels of a camera with structured light.
class StructuredLight {
 public:
  StructuredLight(const DepthView& view, const DepthNoise& noise, std::uint64_t seed,
                  const cv::Mat& depth)
      : view_(view), noise_(noise), seed_(seed), size_(depth.size()), hidden_(view.hidden()) {}

  [[nodiscard]] double operator()(int u, int v, std::uint64_t place) const {
    if (view_.depthAt(u, v) <= 0.0) return 0.0;
    const double lateral = kinectLateralNoise(view_.angleAt(u, v));
    const base::NormalPair shift = base::randomNormals(seed_, place);
    const int from_u = shifted(u, lateral * shift.first, size_.width);
    const int from_v = shifted(v, lateral * shift.second, size_.height);
    const double depth = view_.depthAt(from_u, from_v);
    if (depth < noise_.min_depth || depth > noise_.max_depth || depth <= 0.0) return 0.0;
    const double angle = view_.angleAt(from_u, from_v);
    if (angle > noise_.greatest_angle || hidden_(from_v, from_u) != 0) return 0.0;
    const base::NormalPair normals = base::randomNormals(seed_, place + 1);
    if (normals.second > 0.0 && view_.isBesideEdge(from_u, from_v)) return 0.0;
    const double all = kinectAxialNoise(depth, angle);
    const double rounding = view_.depthPerPixel(depth) * ofRounding(noise_.disparity_step);
    const double rest = std::sqrt(std::max(all * all - rounding * rounding, 0.0));
    const double measured = depth + rest * normals.first;
    if (measured <= 0.0) return 0.0;
    return view_.rounded(view_.disparity(measured), noise_.disparity_step);
  }

 private:
  /// A row or column displaced by `shift`, kept inside the picture.
  static int shifted(int place, double shift, int count) {
    const double most = count - 1;
    return static_cast<int>(std::lround(std::clamp(place + shift, 0.0, most)));
  }

  const DepthView& view_;
  const DepthNoise& noise_;
  std::uint64_t seed_;
  cv::Size size_;
  cv::Mat_<uchar> hidden_;
};

/// Measures the pixels of the left one of two cameras.
class Stereo {
 public:
  Stereo(const DepthView& view, const DepthNoise& noise, std::uint64_t seed)
      : view_(view), noise_(noise), seed_(seed), hidden_(view.hidden()) {}

  [[nodiscard]] double operator()(int u, int v, std::uint64_t place) const {
    const double depth = view_.depthAt(u, v);
    if (depth < noise_.min_depth || depth > noise_.max_depth || depth <= 0.0) return 0.0;
    const double disparity = view_.disparity(depth);
    constexpr double kFirstEdge = -0.5;  // of the other picture [px]
    if (u - disparity < kFirstEdge || hidden_(v, u) != 0) return 0.0;
    const double normal = base::randomNormals(seed_, place).first;
    return view_.rounded(disparity + noise_.disparity_noise * normal, noise_.disparity_step);
  }

 private:
  const DepthView& view_;
  const DepthNoise& noise_;
  std::uint64_t seed_;
  cv::Mat_<uchar> hidden_;
};

template <class Sensor>
cv::Mat measuredBy(const Sensor& sensor, const cv::Size& size) {
  cv::Mat measured(size, CV_32FC1);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      measured.at<float>(v, u) = static_cast<float>(sensor(u, v, depthPlace(u, v, measured)));
    }
  }
  return measured;
}

}  // namespace

double kinectAxialNoise(double depth, double angle) {
  constexpr double kSixtyDegrees = M_PI / 3.0;
  const double ahead = 0.0012 + 0.0019 * (depth - 0.4) * (depth - 0.4);
  if (angle < kSixtyDegrees) return ahead;
  const double rest = std::max(M_PI_2 - angle, 1e-3);
  return ahead + 0.0001 / std::sqrt(depth) * angle * angle / (rest * rest);
}

double kinectLateralNoise(double angle) {
  return 0.8 + 0.035 * angle / std::max(M_PI_2 - angle, 1e-3);
}

cv::Mat measuredDepth(const cv::Mat& depth, const CameraModel& camera, const DepthNoise& noise,
                      std::uint64_t seed) {
  const DepthView view(depth, camera, noise.baseline);
  switch (noise.model) {
    case DepthModel::kStructuredLight:
      return measuredBy(StructuredLight(view, noise, seed, depth), depth.size());
    case DepthModel::kStereo:
      return measuredBy(Stereo(view, noise, seed), depth.size());
    case DepthModel::kExact:
      break;
  }
  return depth;
}

}  // namespace synthetic_dataset::render

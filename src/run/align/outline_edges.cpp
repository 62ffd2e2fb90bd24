#include "run/align/outline_edges.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

namespace synthetic_dataset::run {
namespace {

constexpr double kStep = 0.5;             // from sample to sample along a normal [px]
constexpr double kLeastContrast = 12.0;   // of an edge: sum over blue, green and red
constexpr std::size_t kMostPoints = 500;  // of a scene

/// Where an outline passes between two pixels.
struct OutlinePoint {
  cv::Point inside;        ///< the pixel on the object
  Eigen::Vector2d pixel;   ///< between `inside` and its neighbour outside
  Eigen::Vector2d normal;  ///< unit vector, outwards
};

/// A picture that can be sampled between pixels.
class SmoothPicture {
 public:
  explicit SmoothPicture(const cv::Mat& image) {
    cv::Mat numbers;
    image.convertTo(numbers, CV_32F);
    cv::GaussianBlur(numbers, picture_, cv::Size(7, 7), 1.0);
  }

  [[nodiscard]] bool contains(const Eigen::Vector2d& at) const {
    return at.x() >= 0.0 && at.y() >= 0.0 && at.x() < picture_.cols - 1 &&
           at.y() < picture_.rows - 1;
  }

  [[nodiscard]] cv::Vec3f at(const Eigen::Vector2d& pixel) const {
    const int x = static_cast<int>(pixel.x());
    const int y = static_cast<int>(pixel.y());
    const auto u = static_cast<float>(pixel.x() - x);
    const auto v = static_cast<float>(pixel.y() - y);
    return (1 - v) * ((1 - u) * picture_(y, x) + u * picture_(y, x + 1)) +
           v * ((1 - u) * picture_(y + 1, x) + u * picture_(y + 1, x + 1));
  }

 private:
  cv::Mat_<cv::Vec3f> picture_;
};

double contrastOf(const cv::Vec3f& a, const cv::Vec3f& b) {
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
}

/// The contrast along a normal, from -reach to reach; empty if this leaves the picture.
std::vector<double> profileOf(const SmoothPicture& picture, const OutlinePoint& point,
                              double reach) {
  std::vector<double> profile;
  const int count = static_cast<int>(std::lround(2.0 * reach / kStep)) + 1;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector2d middle = point.pixel + (i * kStep - reach) * point.normal;
    const Eigen::Vector2d before = middle - 0.5 * point.normal;
    const Eigen::Vector2d after = middle + 0.5 * point.normal;
    const bool is_there = picture.contains(before) && picture.contains(after);
    profile.push_back(is_there ? contrastOf(picture.at(before), picture.at(after)) : 0.0);
  }
  return profile;
}

/// The strongest edge along a normal, where distant ones must be stronger; interpolated between
/// samples with a parabola.
std::optional<double> edgeDistance(const SmoothPicture& picture, const OutlinePoint& point,
                                   double reach) {
  const std::vector<double> profile = profileOf(picture, point, reach);
  std::size_t best = 0;
  double best_value = 0.0;
  for (std::size_t i = 1; i + 1 < profile.size(); ++i) {
    if (profile[i] < profile[i - 1] || profile[i] < profile[i + 1]) continue;
    const double far = (static_cast<double>(i) * kStep - reach) / reach;
    const double value = profile[i] * std::exp(-far * far);
    if (value <= best_value) continue;
    best = i;
    best_value = value;
  }
  if (best == 0 || profile[best] < kLeastContrast) return std::nullopt;
  const double before = profile[best - 1];
  const double after = profile[best + 1];
  const double bend = before - 2.0 * profile[best] + after;
  const double shift = bend < 0.0 ? 0.5 * (before - after) / bend : 0.0;
  return (static_cast<double>(best) + std::clamp(shift, -0.5, 0.5)) * kStep - reach;
}

/// Whether the outline belongs to the pixel inside rather than to something in front of it.
bool isOwn(const cv::Mat_<float>& depth, const cv::Point& inside, const cv::Point& outside) {
  return depth(outside) == 0.0F || depth(outside) >= depth(inside);
}

/// Adds the outline of an object's visible mask.
void addOutline(const Mask& mask, const cv::Mat_<float>& depth, std::vector<OutlinePoint>& points) {
  if (mask.empty()) return;
  cv::Mat numbers;
  mask.whole().convertTo(numbers, CV_32F, 1.0 / 255.0);
  cv::Mat_<float> soft;
  cv::GaussianBlur(numbers, soft, cv::Size(0, 0), 1.5);
  const cv::Rect bounds = mask.bounds();
  // The mask's smoothed edge at the image's border is not an edge of the object.
  const cv::Rect inner(2, 2, soft.cols - 4, soft.rows - 4);
  for (int y = bounds.y; y < bounds.br().y; ++y) {
    for (int x = bounds.x; x < bounds.br().x; ++x) {
      const cv::Point inside(x, y);
      if (!inner.contains(inside) || !mask.at(inside)) continue;
      for (const cv::Point& step :
           {cv::Point(1, 0), cv::Point(-1, 0), cv::Point(0, 1), cv::Point(0, -1)}) {
        const cv::Point outside = inside + step;
        if (mask.at(outside) || !isOwn(depth, inside, outside)) continue;
        const Eigen::Vector2d normal(
            soft(y, x - 1) - soft(y, x + 1) + soft(outside.y, outside.x - 1) -
                soft(outside.y, outside.x + 1),
            soft(y - 1, x) - soft(y + 1, x) + soft(outside.y - 1, outside.x) -
                soft(outside.y + 1, outside.x));
        constexpr double kFlat = 1e-3;  // thinner than the smoothing
        if (normal.norm() < kFlat) continue;
        points.push_back({inside, {x + 0.5 * step.x, y + 0.5 * step.y}, normal.normalized()});
      }
    }
  }
}

/// The Jacobian of a point's pixel with respect to the camera's translation and rotation: columns
/// in pixels per metre and per radian.
std::optional<Eigen::Matrix<double, 2, 6>> changeOfPixel(const CameraModel& camera,
                                                         const Eigen::Vector3d& p_C,
                                                         const Pose& X_FC) {
  constexpr double kSmall = 1e-5;
  const Eigen::Vector3d p_F = X_FC * p_C;
  const Pose X_CF = X_FC.inverse();
  Eigen::Matrix<double, 2, 6> change;
  for (int i = 0; i < 6; ++i) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(i % 3);
    // The camera moves along or about the axis, so the point moves the opposite way.
    const Eigen::Vector3d moved = i < 3 ? Eigen::Vector3d(-axis) : Eigen::Vector3d(p_F.cross(axis));
    const auto after = camera.project(X_CF * Eigen::Vector3d(p_F + kSmall * moved));
    const auto before = camera.project(X_CF * Eigen::Vector3d(p_F - kSmall * moved));
    if (!after || !before) return std::nullopt;
    change.col(i) = (*after - *before) / (2.0 * kSmall);
  }
  return change;
}

/// @param depth  z of the pixel [m]
std::optional<Eigen::Vector3d> pointAt(const CameraModel& camera, const cv::Point& pixel,
                                       double depth) {
  const auto ray = camera.ray(Eigen::Vector2d(pixel.x, pixel.y));
  if (!ray || ray->z() <= 0.0 || depth <= 0.0) return std::nullopt;
  return Eigen::Vector3d(*ray * (depth / ray->z()));
}

}  // namespace

std::vector<OutlineEdge> findEdges(const Scene& scene, const OutlineSearch& search) {
  const cv::Mat_<float> depth = scene.depth();
  const cv::Mat_<cv::Vec2f> flow = scene.optical_flow();
  std::vector<OutlinePoint> points;
  for (const SceneObject& object : scene.objects) {
    if (object.labelled()) addOutline(object.visible_mask(), depth, points);
  }
  const SmoothPicture picture(scene.image);
  const std::size_t stride = points.size() / kMostPoints + 1;
  std::vector<OutlineEdge> edges;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    const OutlinePoint& point = points[i];
    const auto distance = edgeDistance(picture, point, search.reach);
    const auto p_C = pointAt(scene.camera, point.inside, depth(point.inside));
    if (!distance || !p_C) continue;
    const auto of_camera = changeOfPixel(scene.camera, *p_C, search.X_FC);
    if (!of_camera) continue;
    // The lens distorts first; then the focal length scales the result.
    const Intrinsics& k = scene.camera.intrinsics();
    const auto seen = scene.camera.project(*p_C);
    if (!seen) continue;
    OutlineEdge edge;
    edge.distance = *distance;
    edge.change[kFocalEntry] = (*seen - Eigen::Vector2d(k.cx, k.cy)).dot(point.normal);
    edge.change.head<6>() = of_camera->transpose() * point.normal;
    const cv::Vec2f moved = flow(point.inside);
    if (search.flow_time && std::isfinite(moved[0]) && std::isfinite(moved[1])) {
      edge.change[kTimeEntry] =
          Eigen::Vector2d(moved[0], moved[1]).dot(point.normal) / *search.flow_time;
    }
    edges.push_back(edge);
  }
  return edges;
}

}  // namespace synthetic_dataset::run

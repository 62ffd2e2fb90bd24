#include "api/curved_bounds.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "api/lens.h"

namespace synthetic_dataset::lens {
namespace {

constexpr double kStraightness =
    0.02;  // [px] how far a piece of an outline may deviate from a straight line

constexpr double kFarthestPixel = 1e12;  // [px]

using Outline = std::vector<Eigen::Vector2d>;

/// Projects directions, whatever the distance along them, and collects the box around the pixels.
class Screen {
 public:
  explicit Screen(const CameraModel& camera) : camera_(camera) {}

  [[nodiscard]] std::optional<Eigen::Vector2d> pixel(const Eigen::Vector3d& direction) const {
    const auto place = distort(camera_.distortion(), camera_.largestAngle(), direction);
    if (!place) return std::nullopt;
    const Intrinsics& k = camera_.intrinsics();
    const Eigen::Vector2d pixel(k.fx * place->x() + k.cx, k.fy * place->y() + k.cy);
    // Farther away precision does not matter, and numbers may overflow or become NaN.
    if (!(pixel.cwiseAbs().maxCoeff() < kFarthestPixel)) return std::nullopt;
    return pixel;
  }

  /// Extends the box to contain a pixel.
  void add(const Eigen::Vector2d& p) {
    if (!box_) box_ = Box{p.x(), p.y(), p.x(), p.y()};
    box_->left = std::min(box_->left, p.x());
    box_->top = std::min(box_->top, p.y());
    box_->right = std::max(box_->right, p.x());
    box_->bottom = std::max(box_->bottom, p.y());
  }

  [[nodiscard]] const std::optional<Box>& box() const { return box_; }

  /// The allowed deviation of an outline from a straight line [px]; it grows with the distance from
  /// the image.
  [[nodiscard]] double straightness(const Eigen::Vector2d& p) const {
    const double outside =
        std::max({-p.x(), p.x() - camera_.width(), -p.y(), p.y() - camera_.height(), 0.0});
    return kStraightness + 1e-3 * outside;
  }

 private:
  const CameraModel& camera_;
  std::optional<Box> box_;
};

/// Adds an arc of a great circle along which the angle to the axis only grows or only shrinks.
/// @param a, b  unit vectors
void addMonotoneArc(Screen& screen, const Eigen::Vector3d& a, const Eigen::Vector3d& b, int depth) {
  constexpr int kCoarsest = 3;  // the least number of halvings
  constexpr int kFinest = 30;
  const auto pixel_a = screen.pixel(a);
  const auto pixel_b = screen.pixel(b);
  if (pixel_a) screen.add(*pixel_a);
  if (pixel_b) screen.add(*pixel_b);
  if ((!pixel_a && !pixel_b) || depth == kFinest) return;
  const Eigen::Vector3d middle = (a + b).normalized();
  const auto pixel = screen.pixel(middle);
  if (pixel && pixel_a && pixel_b && depth >= kCoarsest) {
    const double stray = (*pixel - 0.5 * (*pixel_a + *pixel_b)).norm();
    if (stray <= screen.straightness(*pixel)) return screen.add(*pixel);
  }
  addMonotoneArc(screen, a, middle, depth + 1);
  addMonotoneArc(screen, middle, b, depth + 1);
}

/// Adds the shorter arc of the great circle through two unit vectors.
void addArc(Screen& screen, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d normal = a.cross(b);
  if (normal.norm() > 1e-12) {
    // The points of the great circle that are nearest to the axis and farthest from it.
    const Eigen::Vector3d n = normal.normalized();
    const Eigen::Vector3d nearest = Eigen::Vector3d::UnitZ() - n.z() * n;
    for (const Eigen::Vector3d& turn : {nearest, Eigen::Vector3d(-nearest)}) {
      if (a.cross(turn).dot(n) > 1e-9 && turn.cross(b).dot(n) > 1e-9) {
        addMonotoneArc(screen, a, turn.normalized(), 0);
        addMonotoneArc(screen, turn.normalized(), b, 0);
        return;
      }
    }
  }
  addMonotoneArc(screen, a, b, 0);
}

/// Adds the rim of the lens's field of view where `inside` is true.
template <class Predicate>
void addRim(Screen& screen, double largest_angle, const Predicate& inside) {
  constexpr int kPlaces = 4096;
  const double angle = largest_angle * (1.0 - 1e-9);
  for (int i = 0; i < kPlaces; ++i) {
    const double turn = 2.0 * M_PI * i / kPlaces;
    const Eigen::Vector3d direction(std::sin(angle) * std::cos(turn),
                                    std::sin(angle) * std::sin(turn), std::cos(angle));
    if (!inside(direction)) continue;
    if (const auto pixel = screen.pixel(direction)) screen.add(*pixel);
  }
}

double turnOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d ab = b - a;
  const Eigen::Vector2d ac = c - a;
  return ab.x() * ac.y() - ab.y() * ac.x();
}

/// The convex hull, counter-clockwise (Andrew's monotone chain).
Outline convexOutline(Outline points) {
  const auto before = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Outline hull;
  const auto extend = [&hull](const Eigen::Vector2d& point, std::size_t base) {
    while (hull.size() >= base + 2 && turnOf(hull[hull.size() - 2], hull.back(), point) <= 0.0) {
      hull.pop_back();
    }
    hull.push_back(point);
  };
  for (const Eigen::Vector2d& point : points) extend(point, 0);
  const std::size_t lower = hull.size() - 1;
  for (auto point = points.rbegin() + 1; point != points.rend(); ++point) extend(*point, lower);
  hull.pop_back();
  return hull;
}

/// A direction at an acute angle to all others, found with the perceptron algorithm; nullopt if the
/// camera is inside the hull, or nearly so.
std::optional<Eigen::Vector3d> commonDirection(const std::vector<Eigen::Vector3d>& directions) {
  constexpr int kRounds = 2000;
  constexpr double kLeastCosine = 1e-4;
  Eigen::Vector3d common = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& direction : directions) common += direction;
  for (int i = 0; i < kRounds; ++i) {
    const auto worst = std::min_element(
        directions.begin(), directions.end(),
        [&](const auto& a, const auto& b) { return a.dot(common) < b.dot(common); });
    if (worst->dot(common) > kLeastCosine * common.norm()) return common.normalized();
    common += *worst;
  }
  return std::nullopt;
}

bool holds(const Outline& outline, const Eigen::Vector2d& point) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (turnOf(outline[i], outline[(i + 1) % outline.size()], point) < 0.0) return false;
  }
  return outline.size() > 2;
}

}  // namespace

std::optional<Box> curvedBounds(const CameraModel& camera,
                                const std::vector<Eigen::Vector3d>& points_C) {
  Screen screen(camera);
  std::vector<Eigen::Vector3d> directions;
  for (const Eigen::Vector3d& point : points_C) {
    if (!point.isZero(0.0)) directions.push_back(point.normalized());
  }
  if (directions.empty()) return std::nullopt;
  const bool holds_camera = directions.size() < points_C.size();
  const auto ahead = holds_camera ? std::nullopt : commonDirection(directions);
  if (!ahead) {
    addRim(screen, camera.largestAngle(), [](const Eigen::Vector3d&) { return true; });
    return screen.box();
  }
  // Seen along `ahead` (A), straight edges stay straight, and the hull's outline is that of its
  // corners.
  const Eigen::Matrix3d R_CA =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), *ahead).toRotationMatrix();
  const auto place = [&](const Eigen::Vector3d& direction) {
    return Eigen::Vector3d(R_CA.transpose() * direction).hnormalized().eval();
  };
  Outline corners;
  for (const Eigen::Vector3d& direction : directions) corners.push_back(place(direction));
  const Outline outline = convexOutline(corners);
  const auto direction = [&](const Eigen::Vector2d& p) {
    return Eigen::Vector3d(R_CA * p.homogeneous()).normalized();
  };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    addArc(screen, direction(outline[i]), direction(outline[(i + 1) % outline.size()]));
  }
  addRim(screen, camera.largestAngle(), [&](const Eigen::Vector3d& rim) {
    return rim.dot(*ahead) > 1e-9 && holds(outline, place(rim));
  });
  return screen.box();
}

}  // namespace synthetic_dataset::lens

#include "render/weather/drop_painter.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "render/weather/weather.h"

namespace synthetic_dataset::render {
namespace {

constexpr int kReach = 10;                 // [m] from the camera
constexpr double kFaintest = 1.0 / 255.0;  // a share of a pixel's light
constexpr double kSmallest = 2e-4;         // [m]
constexpr double kLargest = 0.05;          // [m]

/// A straight stroke with round ends.
struct Streak {
  Eigen::Vector2d from;
  Eigen::Vector2d to;
  double width;    ///< [px], at least 1
  double rim;      ///< over which its density falls to 0 [px], half of it inside the width
  double density;  ///< the share of light that it takes in its middle, 0 .. 1
};

/// How wide and how sharp a drop appears.
struct Outline {
  double width;  ///< [px], at least 1
  double rim;    ///< [px]
};

/// @param diameter, aperture  [px]
Outline outlineOf(double diameter, double aperture) {
  return {std::max({diameter, aperture, 1.0}), std::min(diameter, aperture) + 1.0};
}

/// The share of a pixel's light that a moving drop takes: the drop's area divided by that of its
/// streak.
/// @param diameter, width, length  [px]
double densityOf(double diameter, double width, double length) {
  return M_PI / 4.0 * diameter * diameter / (width * length + M_PI / 4.0 * width * width);
}

double distanceToLine(const Eigen::Vector2d& point, const Streak& streak) {
  const Eigen::Vector2d along = streak.to - streak.from;
  const double square = along.squaredNorm();
  const double share =
      square > 0.0 ? std::clamp((point - streak.from).dot(along) / square, 0.0, 1.0) : 0.0;
  return (point - streak.from - share * along).norm();
}

class DropPainter {
 public:
  /// The references have to outlive this.
  DropPainter(const Precipitation& precipitation, const Eigen::Vector3d& wind_G, double exposure,
              const View& view, const cv::Mat& distances, cv::Mat& passing)
      : precipitation_(precipitation),
        wind_G_(wind_G),
        exposure_(exposure),
        view_(view),
        distances_(distances),
        passing_(passing),
        X_CG_(view.X_WC.inverse()),
        focal_(0.5 * (view.camera.intrinsics().fx + view.camera.intrinsics().fy)),
        widest_(widestAngle(view.camera)) {}

  /// Draws the visible drops of a cube that is a cell of Precipitation::in().
  void drawCell(const Eigen::Vector3i& cell, std::uint64_t seed) {
    const Eigen::Vector3d path_G =
        (cell.cast<double>().array() + 0.5).matrix() - view_.X_WC.translation();
    const double distance = path_G.norm();
    if (distance > kReach) return;
    // Half the angle that the cube subtends.
    const double spread = std::asin(std::min(1.0, kHalfDiagonal / distance));
    const Eigen::Vector3d way_C = X_CG_.linear() * path_G;
    if (std::atan2(way_C.head<2>().norm(), way_C.z()) > widest_ + spread) return;
    const double nearest = std::max(distance - kHalfDiagonal, view_.camera.near());
    const double least = leastSeen(path_G / distance, spread, focal_ / nearest);
    for (const Drop& drop : precipitation_.in(cell, least, seed)) draw(drop);
  }

 private:
  static constexpr double kHalfDiagonal = 0.8660254037844386;  // [m] of a cell

  /// The vector by which a drop moves while the shutter is open [m].
  [[nodiscard]] Eigen::Vector3d movement(double diameter) const {
    const double speed = precipitation_.speedOf(diameter);
    return exposure_ * (wind_G_ - speed * Eigen::Vector3d::UnitZ());
  }

  /// @param length  of the drop's path across the view [m]
  /// @param scale  [px/m]
  [[nodiscard]] double density(double diameter, double length, double scale) const {
    const Outline outline = outlineOf(diameter * scale, kLensAperture * scale);
    return precipitation_.opacityOf(diameter) *
           densityOf(diameter * scale, outline.width, length * scale);
  }

  /// The diameter of the smallest drop that is not too faint [m].
  /// @param direction_G, spread  the direction towards the drops, and by how much it may differ
  ///   [rad]
  /// @param scale  [px/m]
  [[nodiscard]] double leastSeen(const Eigen::Vector3d& direction_G, double spread,
                                 double scale) const {
    double low = kSmallest;
    double high = kLargest;
    for (int step = 0; step < 20; ++step) {
      const double middle = 0.5 * (low + high);
      const Eigen::Vector3d path_G = movement(middle);
      const double angle =
          std::atan2(path_G.cross(direction_G).norm(), std::abs(path_G.dot(direction_G)));
      const double length = path_G.norm() * std::sin(std::max(0.0, angle - spread));
      (density(middle, length, scale) >= kFaintest ? high : low) = middle;
    }
    return low;
  }

  /// The largest angle between a camera's axis and its image's corners [rad].
  [[nodiscard]] static double widestAngle(const CameraModel& camera) {
    double widest = 0.0;
    for (const double u : {-0.5, camera.width() - 0.5}) {
      for (const double v : {-0.5, camera.height() - 0.5}) {
        const std::optional<Eigen::Vector3d> ray = camera.ray({u, v});
        if (!ray) return camera.largestAngle();
        widest = std::max(widest, std::atan2(ray->head<2>().norm(), ray->z()));
      }
    }
    return widest;
  }

  void draw(const Drop& drop) {
    const Eigen::Vector3d half_G = 0.5 * movement(drop.diameter);
    const std::optional<Eigen::Vector2d> from = view_.camera.project(X_CG_ * (drop.p_G - half_G));
    const std::optional<Eigen::Vector2d> to = view_.camera.project(X_CG_ * (drop.p_G + half_G));
    if (!from || !to) return;
    const double distance = (X_CG_ * drop.p_G).norm();
    const double scale = focal_ / distance;
    const double dense = density(drop.diameter, (*to - *from).norm() / scale, scale);
    if (dense < kFaintest) return;
    const Outline outline = outlineOf(drop.diameter * scale, kLensAperture * scale);
    draw({*from, *to, outline.width, outline.rim, dense}, static_cast<float>(distance));
  }

  void draw(const Streak& streak, float distance) {
    const double reach = 0.5 * (streak.width + streak.rim);
    const Eigen::Array2d low = streak.from.array().min(streak.to.array()) - reach;
    const Eigen::Array2d high = streak.from.array().max(streak.to.array()) + reach;
    // Compared before rounding to integers: a streak may be anywhere, even out of their range.
    const Eigen::Array2d last(passing_.cols - 1.0, passing_.rows - 1.0);
    if ((high < 0.0).any() || (low > last).any()) return;
    const Eigen::Array2i first_pixel = low.max(0.0).ceil().cast<int>();
    const Eigen::Array2i last_pixel = high.min(last).floor().cast<int>();
    for (int v = first_pixel.y(); v <= last_pixel.y(); ++v) {
      for (int u = first_pixel.x(); u <= last_pixel.x(); ++u) {
        if (distances_.at<float>(v, u) <= distance) continue;
        const double covered =
            std::clamp((reach - distanceToLine({u, v}, streak)) / streak.rim, 0.0, 1.0);
        passing_.at<float>(v, u) *= static_cast<float>(1.0 - streak.density * covered);
      }
    }
  }

  const Precipitation& precipitation_;
  Eigen::Vector3d wind_G_;
  double exposure_;
  const View& view_;
  const cv::Mat& distances_;
  cv::Mat& passing_;
  Pose X_CG_;
  double focal_;
  double widest_;
};

}  // namespace

void drawDrops(const Precipitation& precipitation, const Eigen::Vector3d& wind_G, double exposure,
               const View& view, std::uint64_t seed, const cv::Mat& distances, cv::Mat& passing) {
  DropPainter painter(precipitation, wind_G, exposure, view, distances, passing);
  const Eigen::Vector3i own = view.X_WC.translation().array().floor().cast<int>();
  for (int x = -kReach; x <= kReach; ++x) {
    for (int y = -kReach; y <= kReach; ++y) {
      for (int z = -kReach; z <= kReach; ++z) {
        painter.drawCell(own + Eigen::Vector3i(x, y, z), seed);
      }
    }
  }
}

}  // namespace synthetic_dataset::render

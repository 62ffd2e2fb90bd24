#include "lidar/recorded_cloud.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <optional>
#include <thread>

#include <Eigen/Geometry>

namespace synthetic_dataset::lidar {
namespace {

using base::Placement;
using motion::MeasuredPoint;

/// How far behind a hit the search for the next surface on a ray starts: hits nearer to one another
/// count as one surface [m].
constexpr double kApart = 1e-4;

/// Time between two samples of the scanner's path.
constexpr Duration kPathStep = std::chrono::microseconds(50);

/// How far something may deviate from the line between its positions at two moments [m].
constexpr double kBend = 0.05;

/// The ray to a point.
struct PointRay {
  Eigen::Vector3d origin_W;
  Eigen::Vector3d direction_W;
  double range = 0.0;
};

/// The box that a moving body's bounding sphere sweeps meanwhile.
struct BodyWay {
  std::size_t moving = 0;  ///< its index in ScannedWorld::moving()
  Eigen::AlignedBox3d bounds_W;
};

class CloudLabeller {
 public:
  CloudLabeller(const ScannedWorld& world, const RecordedSweepOptions& options,
                const RecordedMotion& motion, const std::vector<LinkLabel>& labels,
                const Paint& paint)
      : world_(world),
        options_(options),
        motion_(motion),
        labels_(labels),
        paint_(paint),
        X_SG_at_stamp_(motion.X_GS_at_stamp.inverse()) {
    for (std::size_t i = 0; i < world.moving().size(); ++i) {
      const MovingBody& body = world.moving()[i];
      if (!motion.present[body.link]) continue;
      Eigen::AlignedBox3d centres_W;
      for (const WorldMoment& moment : motion.moments) {
        centres_W.extend(centreOf(body, moment.X_WL[i]));
      }
      const Eigen::Vector3d around =
          Eigen::Vector3d::Constant(body.radius + options.tolerance + kBend);
      ways_.push_back({i, Eigen::AlignedBox3d(centres_W.min() - around, centres_W.max() + around)});
    }
  }

  [[nodiscard]] CloudPoint label(const MeasuredPoint& measured) const {
    CloudPoint point;
    const Placement X_GS = motion_.path.at(measured.time);
    const Eigen::Vector3d p_G = X_GS.position + X_GS.turn * measured.position;
    point.position_S = measured.position.cast<float>();
    point.position_at_stamp_S = (X_SG_at_stamp_ * p_G).cast<float>();
    point.intensity =
        static_cast<float>(std::clamp(measured.intensity / options_.full_intensity, 0.0, 1.0));
    point.time = static_cast<std::int32_t>(measured.time.count());
    point.column = measured.column;
    point.ring = static_cast<std::uint16_t>(measured.ring);
    const double range = measured.position.norm();
    const PointRay ray{X_GS.position, X_GS.turn * (measured.position / range), range};
    const auto met = surfaceAt(ray, p_G, static_cast<double>(measured.time.count()));
    if (!met) return point;
    const RaySurface& surface = world_.bodies().surfaces()[met->hit.surface];
    point.normal_S =
        (X_GS.turn.conjugate() * normalOf(*met, surface, ray.direction_W)).cast<float>();
    setLabel(labels_[surface.link], point);
    return point;
  }

 private:
  [[nodiscard]] static Eigen::Vector3d centreOf(const MovingBody& body, const Placement& X_WL) {
    return X_WL.position + X_WL.turn * body.centre_L;
  }

  /// @param time  from the stamp [ns]
  [[nodiscard]] std::optional<SurfaceHit> surfaceAt(const PointRay& ray, const Eigen::Vector3d& p_W,
                                                    double time) const {
    std::optional<SurfaceHit> nearest;
    const auto consider = [&](const std::optional<RayHit>& hit, const Eigen::Matrix3d& R_WB) {
      if (!hit || (nearest && missOf(*hit, ray) >= missOf(nearest->hit, ray))) return;
      nearest = SurfaceHit{*hit, R_WB};
    };
    if (world_.standing()) {
      consider(surfaceOf(*world_.standing(), ray.origin_W - world_.standingOrigin(),
                         ray.direction_W, ray.range),
               Eigen::Matrix3d::Identity());
    }
    for (const BodyWay& way : ways_) {
      if (!way.bounds_W.contains(p_W)) continue;
      const MovingBody& body = world_.moving()[way.moving];
      const Placement X_WL = placementAt(motion_.moments, &WorldMoment::X_WL, way.moving, time);
      if ((centreOf(body, X_WL) - p_W).norm() > body.radius + options_.tolerance) continue;
      const Eigen::Quaterniond R_LW(X_WL.turn.conjugate());
      consider(surfaceOf(body.body, R_LW * (ray.origin_W - X_WL.position), R_LW * ray.direction_W,
                         ray.range),
               R_LW.conjugate().toRotationMatrix());
    }
    return nearest;
  }

  [[nodiscard]] static double missOf(const RayHit& hit, const PointRay& ray) {
    return std::abs(hit.distance - ray.range);
  }

  /// The surface of a body that is nearest to the given range along a ray, within the tolerance.
  /// Surfaces that the ray passes before do not count: they were not there, or the scanner saw
  /// through them.
  [[nodiscard]] std::optional<RayHit> surfaceOf(std::size_t body, const Eigen::Vector3d& origin_B,
                                                const Eigen::Vector3d& direction_B,
                                                double range) const {
    std::optional<RayHit> nearest;
    double from = std::max(range - options_.tolerance, 0.0);
    const double to = range + options_.tolerance;
    while (from < to) {
      const auto hit = world_.bodies().meet(body, origin_B, direction_B, from, to, paint_);
      if (!hit) break;
      if (!nearest || std::abs(hit->distance - range) < std::abs(nearest->distance - range)) {
        nearest = hit;
      }
      if (hit->distance >= range) break;
      from = std::max(from, hit->distance) + kApart;
    }
    return nearest;
  }

  const ScannedWorld& world_;
  const RecordedSweepOptions& options_;
  const RecordedMotion& motion_;
  const std::vector<LinkLabel>& labels_;
  const Paint& paint_;
  Pose X_SG_at_stamp_;
  std::vector<BodyWay> ways_;
};

}  // namespace

ScannerPath::ScannerPath(const motion::TimeRange& times,
                         const std::function<Placement(Duration offset)>& poseAt)
    : times_(times) {
  for (Duration offset = times.first; offset < times.last; offset += kPathStep) {
    X_GS_.push_back(poseAt(offset));
  }
  X_GS_.push_back(poseAt(times.last));
}

Placement ScannerPath::at(Duration offset) const {
  const Duration since = std::max(offset - times_.first, Duration{0});
  const auto step = static_cast<std::size_t>(since / kPathStep);
  if (step + 1 >= X_GS_.size()) return X_GS_.back();
  const Duration begin = times_.first + static_cast<std::int64_t>(step) * kPathStep;
  const Duration end = std::min(begin + kPathStep, times_.last);
  return base::between(X_GS_[step], X_GS_[step + 1],
                       toSeconds(offset - begin) / toSeconds(end - begin));
}

LabelledCloud labelledCloud(const ScannedWorld& world, const motion::MeasuredCloud& measured,
                            const RecordedSweepOptions& options, const RecordedMotion& motion,
                            const std::vector<LinkLabel>& labels, const Paint& paint) {
  const CloudLabeller labeller(world, options, motion, labels, paint);
  LabelledCloud result;
  result.cloud.X_GS = motion.X_GS_at_stamp;
  result.cloud.columns = static_cast<int>(measured.columns);
  result.cloud.rings = static_cast<int>(measured.rings);
  std::vector<CloudPoint>& points = result.cloud.points;
  points.resize(measured.points.size());
  const std::size_t threads = std::clamp(std::thread::hardware_concurrency(), 1U, 64U);
  const std::size_t band = (points.size() + threads - 1) / threads;
  std::vector<std::future<void>> bands;
  for (std::size_t begin = 0; begin < points.size(); begin += band) {
    const std::size_t end = std::min(begin + band, points.size());
    // Deferred if no more threads are available.
    bands.push_back(std::async(std::launch::async | std::launch::deferred, [&, begin, end] {
      for (std::size_t i = begin; i < end; ++i) points[i] = labeller.label(measured.points[i]);
    }));
  }
  for (std::future<void>& each : bands) each.get();
  for (const CloudPoint& point : points) result.unknown += point.normal_S.isZero(0.0F) ? 1 : 0;
  for (const MeasuredPoint& point : measured.points) {
    result.too_bright += point.intensity > options.full_intensity ? 1 : 0;
  }
  return result;
}

}  // namespace synthetic_dataset::lidar

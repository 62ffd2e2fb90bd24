#include "lidar/sweep.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <optional>
#include <thread>
#include <utility>

#include "base/random/random_seed.h"
#include "lidar/surface_look.h"

namespace synthetic_dataset::lidar {
namespace {

using base::Placement;

/// How far something may move while a column fires without being missed by the culling of bodies
/// [m].
constexpr double kColumnReach = 0.05;

/// A cone that contains the rays of column 0 and, turned about z, those of every other column.
struct Fan {
  explicit Fan(const FiringPlan& plan) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int ring = 0; ring < plan.rings(); ++ring) sum += plan.direction(0, ring);
    is_narrow = sum.norm() > 1e-3;
    if (!is_narrow) return;
    axis_S = sum.normalized();
    double least = 1.0;
    for (int ring = 0; ring < plan.rings(); ++ring) {
      least = std::min(least, axis_S.dot(plan.direction(0, ring)));
    }
    constexpr double kRounding = 1e-3;  // [rad]
    const double half_angle = std::acos(std::clamp(least, -1.0, 1.0)) + kRounding;
    cosine = std::cos(half_angle);
    sine = std::sin(half_angle);
  }

  Eigen::Vector3d axis_S{1, 0, 0};  ///< of column 0
  double cosine = 1.0;              ///< of the angle between its axis and the outermost ray
  double sine = 0.0;                ///< of that angle
  bool is_narrow = false;           ///< otherwise rays go everywhere
};

/// Where everything is when a ray is sent.
struct Instant {
  struct Body {
    const MovingBody* body = nullptr;
    Eigen::Quaterniond R_LW;      ///< of its link
    Eigen::Vector3d p_LS;         ///< the scanner, in its link
    Eigen::Vector3d to_centre_W;  ///< from the scanner to the middle of its sphere
  };

  double share = -1.0;  ///< fraction of the column's time; rings that fire together share it
  double time = 0.0;    ///< from the stamp [ns]
  Placement X_GS;
  Pose X_GS_pose = Pose::Identity();
  std::vector<Body> near;  ///< the bodies that rays may hit
};

/// A ray in the world's frame.
struct Ray {
  Eigen::Vector3d origin_W;
  Eigen::Vector3d direction_W;
};

class Sweeper {
 public:
  Sweeper(const ScannedWorld& world, const LidarModel& model, const FiringPlan& plan,
          const SweepMotion& motion, const std::vector<LinkLabel>& labels, const Paint& paint,
          std::uint64_t seed)
      : world_(world),
        model_(model),
        plan_(plan),
        motion_(motion),
        labels_(labels),
        paint_(paint),
        seed_(seed),
        fan_(plan),
        X_SG_at_stamp_(motion.X_GS_at_stamp.inverse()) {
    for (const WorldMoment& moment : motion.moments) {
      std::vector<Eigen::Vector3d>& centres = centres_W_.emplace_back();
      for (std::size_t i = 0; i < world.moving().size(); ++i) {
        const Placement& X_WL = moment.X_WL[i];
        centres.emplace_back(X_WL.position + X_WL.turn * world.moving()[i].centre_L);
      }
    }
  }

  /// The points of the columns from `begin` up to, not including, `end`.
  [[nodiscard]] std::vector<CloudPoint> scan(int begin, int end) const {
    std::vector<CloudPoint> points;
    points.reserve(static_cast<std::size_t>(end - begin) * static_cast<std::size_t>(plan_.rings()));
    Instant instant;
    for (int column = begin; column < end; ++column) {
      const std::vector<std::size_t> near = bodiesNear(column);
      instant.share = -1.0;
      for (int ring = 0; ring < plan_.rings(); ++ring) {
        if (plan_.share(ring) != instant.share) find(column, plan_.share(ring), near, instant);
        if (auto point = cast(column, ring, instant)) points.push_back(*point);
      }
    }
    return points;
  }

 private:
  [[nodiscard]] Placement scannerAt(int column, double share) const {
    const auto at = static_cast<std::size_t>(column);
    return base::between(motion_.X_GS[at], motion_.X_GS[at + 1], share);
  }

  [[nodiscard]] double timeOf(int column, double share) const {
    const auto begin = static_cast<double>(plan_.columnTime(column).count());
    const auto end = static_cast<double>(plan_.columnTime(column + 1).count());
    return begin + share * (end - begin);
  }

  /// The pose of a moving body. @param time  from the stamp [ns]
  [[nodiscard]] Placement bodyAt(std::size_t moving, double time) const {
    return placementAt(motion_.moments, &WorldMoment::X_WL, moving, time);
  }

  /// Finds where everything is at a fraction of a column's time.
  void find(int column, double share, const std::vector<std::size_t>& near,
            Instant& instant) const {
    instant.share = share;
    instant.time = timeOf(column, share);
    instant.X_GS = scannerAt(column, share);
    instant.X_GS_pose = instant.X_GS.pose();
    instant.near.clear();
    for (const std::size_t i : near) {
      const MovingBody& body = world_.moving()[i];
      const Placement X_WL = bodyAt(i, instant.time);
      const Eigen::Vector3d from = instant.X_GS.position - X_WL.position;
      const Eigen::Quaterniond R_LW(X_WL.turn.conjugate());
      instant.near.push_back({&body, R_LW, R_LW * from, X_WL.turn * body.centre_L - from});
    }
  }

  /// The moving bodies that rays of a column may hit.
  [[nodiscard]] std::vector<std::size_t> bodiesNear(int column) const {
    const Placement X_GS = scannerAt(column, 0.0);
    const double azimuth_0 = std::atan2(plan_.direction(0, 0).y(), plan_.direction(0, 0).x());
    const Eigen::Vector3d here = plan_.direction(column, 0);
    const double turned = std::atan2(here.y(), here.x()) - azimuth_0;
    const Eigen::Vector3d axis_W =
        X_GS.turn * (Eigen::AngleAxisd(turned, Eigen::Vector3d::UnitZ()) * fan_.axis_S);
    const MomentsAround around = momentsAround(motion_.moments, timeOf(column, 0.0));
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < world_.moving().size(); ++i) {
      const MovingBody& body = world_.moving()[i];
      if (!motion_.present[body.link]) continue;
      const Eigen::Vector3d& before = centres_W_[around.before][i];
      const Eigen::Vector3d to_body =
          before + around.share * (centres_W_[around.after][i] - before) - X_GS.position;
      const double radius = body.radius + kColumnReach;
      const double distance = to_body.norm();
      if (distance - radius > model_.max_range) continue;
      if (fan_.is_narrow && distance > radius && isBeside(to_body, distance, radius, axis_W)) {
        continue;
      }
      near.push_back(i);
    }
    return near;
  }

  /// Whether a sphere is outside the fan: its centre is farther from the axis than the fan's half
  /// angle plus the sphere's angular radius.
  [[nodiscard]] bool isBeside(const Eigen::Vector3d& to_ball, double distance, double radius,
                              const Eigen::Vector3d& axis) const {
    const double sine = radius / distance;
    const double cosine = std::sqrt(1.0 - sine * sine);
    const bool is_half_turn = fan_.sine * cosine + fan_.cosine * sine <= 0.0;
    if (is_half_turn) return false;
    return to_ball.dot(axis) < distance * (fan_.cosine * cosine - fan_.sine * sine);
  }

  [[nodiscard]] std::optional<SurfaceHit> meet(const Ray& ray, const Instant& instant) const {
    std::optional<SurfaceHit> met;
    double far = model_.max_range;
    if (world_.standing()) {
      const auto hit =
          world_.bodies().meet(*world_.standing(), ray.origin_W - world_.standingOrigin(),
                               ray.direction_W, model_.min_range, far, paint_);
      if (hit) met = SurfaceHit{*hit};
      if (hit) far = hit->distance;
    }
    for (const auto& [body, R_LW, p_LS, to_centre_W] : instant.near) {
      const double along = to_centre_W.dot(ray.direction_W);
      const double off_squared = to_centre_W.squaredNorm() - along * along;
      if (off_squared > body->radius * body->radius) continue;
      const auto hit = world_.bodies().meet(body->body, p_LS, R_LW * ray.direction_W,
                                            model_.min_range, far, paint_);
      if (!hit || hit->distance >= far) continue;
      met = SurfaceHit{*hit, R_LW.conjugate().toRotationMatrix()};
      far = hit->distance;
    }
    return met;
  }

  [[nodiscard]] std::optional<CloudPoint> cast(int column, int ring, const Instant& instant) const {
    const Placement& X_GS = instant.X_GS;
    const Eigen::Vector3d direction_S = plan_.direction(column, ring);
    const Ray ray{X_GS.position, X_GS.turn * direction_S};
    const auto met = meet(ray, instant);
    if (!met || met->hit.distance > model_.max_range || met->hit.distance < model_.min_range) {
      return std::nullopt;
    }
    const RaySurface& surface = world_.bodies().surfaces()[met->hit.surface];
    const SurfacePlace place{met->hit.triangle, met->hit.b1, met->hit.b2};
    const Eigen::Vector3d normal_W = normalOf(*met, surface, ray.direction_W);
    const double cosine = std::clamp(-normal_W.dot(ray.direction_W), 0.0, 1.0);
    const double intensity =
        intensityAt(*surface.mesh, *paint_[met->hit.surface], place, world_.simulator(), cosine);
    const auto number =
        static_cast<std::uint64_t>(column) * static_cast<std::uint64_t>(plan_.rings()) +
        static_cast<std::uint64_t>(ring);
    if (isLost(number, met->hit.distance, intensity)) return std::nullopt;
    const Eigen::Vector3d position_S = measured(number, met->hit.distance) * direction_S;

    CloudPoint point;
    point.position_S = position_S.cast<float>();
    point.position_at_stamp_S = (X_SG_at_stamp_ * (instant.X_GS_pose * position_S)).cast<float>();
    point.normal_S = (X_GS.turn.conjugate() * normal_W).cast<float>();
    point.intensity = static_cast<float>(intensity);
    point.time = static_cast<std::int32_t>(std::llround(instant.time));
    point.column = static_cast<std::uint32_t>(column);
    point.ring = static_cast<std::uint16_t>(ring);
    setLabel(labels_[surface.link], point);
    return point;
  }

  /// Whether too little of a ray comes back to be detected. At `reach_at_tenth`, nine in ten
  /// returns from a surface of 10 % reflectivity are detected, and half of them if two thirds as
  /// much light comes back, as in Ouster's data sheets.
  [[nodiscard]] bool isLost(std::uint64_t number, double range, double intensity) const {
    double probability = 1.0 - model_.dropout;
    if (model_.reach_at_tenth) {
      const double of_reach = range / *model_.reach_at_tenth;
      const double signal = intensity / (0.1 * of_reach * of_reach);
      probability *= std::clamp(0.9 + 1.2 * (signal - 1.0), 0.0, 1.0);
    }
    if (probability >= 1.0) return false;
    const std::uint64_t bits = base::mixedBits(seed_ + (number + 1) * base::kCounterStep);
    constexpr double kUnit = 1.0 / 9007199254740992.0;  // 2^-53
    return static_cast<double>(bits >> 11U) * kUnit >= probability;
  }

  [[nodiscard]] double measured(std::uint64_t number, double range) const {
    double result = range;
    if (model_.noise > 0.0) {
      result += model_.noise * base::randomNormals(seed_, number).first;
    }
    if (model_.resolution > 0.0) {
      result = std::round(result / model_.resolution) * model_.resolution;
    }
    return std::max(result, 0.0);
  }

  const ScannedWorld& world_;
  const LidarModel& model_;
  const FiringPlan& plan_;
  const SweepMotion& motion_;
  const std::vector<LinkLabel>& labels_;
  const Paint& paint_;
  std::uint64_t seed_;
  Fan fan_;
  Pose X_SG_at_stamp_;
  std::vector<std::vector<Eigen::Vector3d>> centres_W_;  ///< at each moment, of moving bodies
};

}  // namespace

Cloud sweep(const ScannedWorld& world, const LidarModel& model, const FiringPlan& plan,
            const SweepMotion& motion, const std::vector<LinkLabel>& labels, const Paint& paint,
            std::uint64_t seed) {
  const Sweeper sweeper(world, model, plan, motion, labels, paint, seed);
  const int threads = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 64);
  const int band = (plan.columns() + threads - 1) / threads;
  std::vector<std::future<std::vector<CloudPoint>>> bands;
  for (int begin = 0; begin < plan.columns(); begin += band) {
    const int end = std::min(begin + band, plan.columns());
    // Deferred if no more threads are available.
    bands.push_back(std::async(std::launch::async | std::launch::deferred,
                               [&sweeper, begin, end] { return sweeper.scan(begin, end); }));
  }
  Cloud cloud;
  cloud.X_GS = motion.X_GS_at_stamp;
  cloud.columns = plan.columns();
  cloud.rings = plan.rings();
  for (auto& each : bands) {
    const std::vector<CloudPoint> points = each.get();
    cloud.points.insert(cloud.points.end(), points.begin(), points.end());
  }
  return cloud;
}

}  // namespace synthetic_dataset::lidar

#include "lidar/sweep_taker.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "base/random/random_seed.h"

namespace synthetic_dataset::lidar {
namespace {

using base::Placement;

/// Time between two samples of the world: something that moves at 10 m/s covers 5 mm, and something
/// whose speed changes by 1 m/s in between is at most an eighth of a millimetre from its
/// interpolated position.
constexpr Duration kLookPeriod = std::chrono::microseconds(500);

/// Counts the points of each object.
std::vector<std::int64_t> countPoints(const Cloud& cloud, std::size_t object_count) {
  std::vector<std::int64_t> counts(object_count, 0);
  for (const CloudPoint& point : cloud.points) {
    if (point.instance > 0) ++counts.at(point.instance - std::size_t{1});
  }
  return counts;
}

/// What the user should know about a recorded cloud.
/// @param group  the full name of the lidar's settings
std::vector<base::Warning> warningsOf(const std::string& group, const LabelledCloud& made) {
  std::vector<base::Warning> warnings;
  const std::string of = " of " + std::to_string(made.cloud.points.size()) + " in a cloud";
  if (made.unknown > 0) {
    warnings.push_back({group +
                            "/cloud_topic: points without label, as the world has nothing within "
                            "label_tolerance of them",
                        std::to_string(made.unknown) + of, made.unknown});
  }
  if (made.too_bright > 0) {
    warnings.push_back({group + "/full_intensity: points with a higher recorded intensity count "
                                "as full",
                        std::to_string(made.too_bright) + of, made.too_bright});
  }
  return warnings;
}

/// Keeps the materials alive that the paint points to.
struct HeldPaint {
  std::map<const world::Material*, world::Material> materials;
  Paint paint;
};

}  // namespace

SweepTaker::SweepTaker(const world::World& world, const motion::FrameSource& frames,
                       const std::vector<LidarRig>& lidars, std::vector<LinkLabel> labels,
                       render::GlassInLabels glass, std::int64_t seed)
    : world_(world),
      frames_(frames),
      lidars_(lidars),
      scanned_(std::make_shared<ScannedWorld>(world, glass)),
      labels_(std::make_shared<const std::vector<LinkLabel>>(std::move(labels))),
      seed_(static_cast<std::uint64_t>(seed)) {
  for (const world::LinkInstance& link : world_.links()) {
    if (link.object >= 0) {
      object_count_ = std::max(object_count_, static_cast<std::size_t>(link.object) + 1);
    }
  }
  can_move_ = !scanned_->moving().empty() ||
              std::any_of(lidars_.begin(), lidars_.end(),
                          [](const LidarRig& lidar) { return lidar.link.has_value(); });
}

std::vector<Duration> SweepTaker::offsets(Stamp stamp) const {
  std::set<Duration> offsets = {Duration{0}};
  for (const LidarRig& lidar : lidars_) {
    if (!can_move_) break;
    const motion::TimeRange times = lidar.sweepAt(stamp);
    // At whole periods from the stamp, so that lidars share most of them.
    for (auto i = times.first / kLookPeriod; i * kLookPeriod < times.last; ++i) {
      if (i * kLookPeriod > times.first) offsets.insert(i * kLookPeriod);
    }
    offsets.insert({times.first, times.last});
  }
  return {offsets.begin(), offsets.end()};
}

void SweepTaker::begin(Stamp stamp) {
  stamp_ = stamp;
  offsets_ = offsets(stamp);
  moments_.clear();
}

void SweepTaker::look(Duration offset) {
  if (!std::binary_search(offsets_.begin(), offsets_.end(), offset)) return;
  WorldMoment& moment = moments_.emplace_back();
  moment.offset = offset;
  for (const MovingBody& body : scanned_->moving()) {
    moment.X_WL.emplace_back(world_.linkPoses()[body.link]);
  }
  for (const LidarRig& lidar : lidars_) {
    moment.X_WS.emplace_back(lidar.link ? world_.linkPoses()[*lidar.link] * lidar.X_FS
                                        : Pose::Identity());
  }
}

Placement SweepTaker::lidarAt(std::size_t lidar, const std::vector<WorldMoment>& moments,
                              Duration offset) const {
  if (!lidars_[lidar].link) return Placement(lidarPose(lidars_[lidar], frames_, stamp_, offset));
  return placementAt(moments, &WorldMoment::X_WS, lidar, static_cast<double>(offset.count()));
}

PendingClouds SweepTaker::take(std::int64_t instant,
                               const std::map<const world::Material*, world::Material>& materials) {
  const auto pending = std::make_shared<std::vector<MakeCloud>>();
  const std::vector<WorldMoment> moments = std::exchange(moments_, {});
  for (std::size_t i = 0; i < lidars_.size(); ++i) {
    pending->push_back(lidars_[i].recorded ? recordedCloud(i, moments)
                                           : castCloud(i, instant, moments));
  }
  const auto held = std::make_shared<HeldPaint>();
  held->materials = materials;
  held->paint = scanned_->paint(held->materials);
  return [pending, held, count = object_count_,
          made = std::make_shared<std::optional<TakenClouds>>()] {
    if (*made) return **made;
    TakenClouds taken;
    for (const MakeCloud& make : *pending) {
      Cloud cloud = make(held->paint, taken.warnings);
      cloud.lidar = taken.clouds.size();
      cloud.points_of_objects = countPoints(cloud, count);
      taken.clouds.push_back(std::make_shared<const Cloud>(std::move(cloud)));
    }
    pending->clear();
    *made = taken;
    return taken;
  };
}

SweepTaker::MakeCloud SweepTaker::castCloud(std::size_t lidar, std::int64_t instant,
                                            const std::vector<WorldMoment>& moments) const {
  FiringPlan plan(lidars_[lidar].model);
  std::vector<Placement> X_GS;
  for (int column = 0; column <= plan.columns(); ++column) {
    X_GS.push_back(lidarAt(lidar, moments, plan.columnTime(column)));
  }
  const auto seed = base::randomSeed(seed_, instant, "lidar " + lidars_[lidar].name);
  return
      [scanned = scanned_, labels = labels_, model = lidars_[lidar].model, plan = std::move(plan),
       motion = SweepMotion{moments, world_.presentLinks(), std::move(X_GS),
                            lidarAt(lidar, moments, Duration{0}).pose()},
       seed](const Paint& paint, std::vector<base::Warning>& /*warnings*/) {
        return sweep(*scanned, model, plan, motion, *labels, paint, seed);
      };
}

SweepTaker::MakeCloud SweepTaker::recordedCloud(std::size_t lidar,
                                                const std::vector<WorldMoment>& moments) const {
  const auto& recorded = lidars_[lidar].recorded;
  ScannerPath path(recorded->timesAround(stamp_),
                   [&](Duration offset) { return lidarAt(lidar, moments, offset); });
  return [scanned = scanned_, labels = labels_, group = lidars_[lidar].group, recorded,
          stamp = stamp_,
          motion = RecordedMotion{moments, world_.presentLinks(), std::move(path),
                                  lidarAt(lidar, moments, Duration{0}).pose()}](
             const Paint& paint, std::vector<base::Warning>& warnings) {
    LabelledCloud made =
        labelledCloud(*scanned, recorded->read(stamp), recorded->options(), motion, *labels, paint);
    for (base::Warning& warning : warningsOf(group, made)) warnings.push_back(std::move(warning));
    return std::move(made.cloud);
  };
}

}  // namespace synthetic_dataset::lidar

#include "lidar/sweep_taker.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/random/random_seed.h"

namespace synthetic_dataset::lidar {
namespace {

using base::Placement;

/// From one look at the world to the next: what moves at 10 m/s gets 5 mm ahead, and what changes
/// its speed by 1 m/s in between is at most an eighth of a millimetre from where it is taken to be.
constexpr Duration kLookPeriod = std::chrono::microseconds(500);

/// Counts the points of each object.
std::vector<std::int64_t> countPoints(const Cloud& cloud, std::size_t object_count) {
  std::vector<std::int64_t> counts(object_count, 0);
  for (const CloudPoint& point : cloud.points) {
    if (point.instance > 0) ++counts.at(point.instance - std::size_t{1});
  }
  return counts;
}

/// One sweep that is still to be cast.
struct PendingSweep {
  LidarModel model;
  FiringPlan plan;
  SweepMotion motion;
  std::uint64_t seed;
};

/// How surfaces look for a while.
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
      seed_(static_cast<std::uint64_t>(seed)),
      offsets_{Duration{0}} {
  Duration half{0};
  for (const LidarRig& lidar : lidars_) {
    plans_.emplace_back(lidar.model);
    half = std::max(half, plans_.back().columnTime(plans_.back().columns()));
  }
  for (const world::LinkInstance& link : world_.links()) {
    if (link.object >= 0) {
      object_count_ = std::max(object_count_, static_cast<std::size_t>(link.object) + 1);
    }
  }
  const bool rides = std::any_of(lidars_.begin(), lidars_.end(),
                                 [](const LidarRig& lidar) { return lidar.link.has_value(); });
  if (scanned_->moving().empty() && !rides) return;
  for (Duration offset = kLookPeriod; offset < half; offset += kLookPeriod) {
    offsets_.push_back(offset);
    offsets_.push_back(-offset);
  }
  if (half.count() > 0) offsets_.insert(offsets_.end(), {half, -half});
  std::sort(offsets_.begin(), offsets_.end());
}

void SweepTaker::look(Duration offset) {
  if (!std::binary_search(offsets_.begin(), offsets_.end(), offset)) return;
  if (offset == offsets_.front()) moments_.clear();
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
                              Stamp stamp, Duration offset) const {
  if (!lidars_[lidar].link) return Placement(lidarPose(lidars_[lidar], frames_, stamp, offset));
  return placementAt(moments, &WorldMoment::X_WS, lidar, static_cast<double>(offset.count()));
}

PendingClouds SweepTaker::take(std::int64_t instant, Stamp stamp,
                               const std::map<const world::Material*, world::Material>& materials) {
  const auto pending = std::make_shared<std::vector<PendingSweep>>();
  const std::vector<WorldMoment> moments = std::exchange(moments_, {});
  for (std::size_t i = 0; i < lidars_.size(); ++i) {
    std::vector<Placement> X_GS;
    for (int column = 0; column <= plans_[i].columns(); ++column) {
      X_GS.push_back(lidarAt(i, moments, stamp, plans_[i].columnTime(column)));
    }
    pending->push_back({lidars_[i].model,
                        plans_[i],
                        {moments, world_.presentLinks(), std::move(X_GS),
                         lidarAt(i, moments, stamp, Duration{0}).pose()},
                        base::randomSeed(seed_, instant, "lidar " + lidars_[i].name)});
  }
  const auto held = std::make_shared<HeldPaint>();
  held->materials = materials;
  held->paint = scanned_->paint(held->materials);
  return [pending, held, scanned = scanned_, labels = labels_, count = object_count_,
          made = std::make_shared<std::optional<Clouds>>()] {
    if (*made) return **made;
    Clouds clouds;
    for (const PendingSweep& each : *pending) {
      Cloud cloud =
          sweep(*scanned, each.model, each.plan, each.motion, *labels, held->paint, each.seed);
      cloud.lidar = clouds.size();
      cloud.points_of_objects = countPoints(cloud, count);
      clouds.push_back(std::make_shared<const Cloud>(std::move(cloud)));
    }
    pending->clear();
    *made = clouds;
    return clouds;
  };
}

}  // namespace synthetic_dataset::lidar

/// A sweep of a moving scanner among moving objects, compared with rays that Bullet casts one by
/// one, each at its own time.

#include <cstdlib>
#include <map>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lidar/firing_plan.h"
#include "lidar/scanned_hall.h"
#include "world/physics/ray_caster.h"

namespace synthetic_dataset::lidar {
namespace sweep_truth_test {

using test::kSweepTime;
using test::ScannedHall;

constexpr double kMillimetre = 0.001;

/// What one ray meets, according to the cloud or to the judge.
struct Seen {
  std::uint16_t part = 0;
  std::uint16_t world_class = 0;
  double range = 0.0;  ///< 0: nothing
};

class Judge {
 public:
  explicit Judge(ScannedHall& hall)
      : hall_(hall),
        labels_(hall.labels()),
        caster_(hall.world().links(), hall.linkPoses(kSweepTime)) {}

  void setTime(Stamp time) {
    if (time == time_) return;
    time_ = time;
    caster_.setLinkPoses(hall_.linkPoses(time));
  }

  [[nodiscard]] Seen look(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const {
    const auto hit = caster_.cast(from, direction, 100.0);
    if (!hit) return {};
    return {labels_[hit->link].part, labels_[hit->link].world_class, hit->distance};
  }

 private:
  ScannedHall& hall_;
  std::vector<LinkLabel> labels_;
  world::RayCaster caster_;
  Stamp time_{0};
};

bool areAlike(const Seen& found, const Seen& right) {
  return found.part == right.part && found.world_class == right.world_class &&
         std::abs(found.range - right.range) <= kMillimetre;
}

/// Whether a ray that passes within a millimetre of this ray's end sees what was found.
bool isByAnEdge(const Judge& judge, const Seen& found, const Eigen::Vector3d& from,
                const Eigen::Vector3d& direction, double range) {
  const Eigen::Vector3d right = direction.unitOrthogonal();
  const Eigen::Vector3d up = direction.cross(right);
  for (int i = 0; i < 8; ++i) {
    const double angle = M_PI_4 * i;
    const Eigen::Vector3d aim =
        from + range * direction + kMillimetre * (std::cos(angle) * right + std::sin(angle) * up);
    Seen beside = judge.look(from, (aim - from).normalized());
    if (found.part != beside.part || found.world_class != beside.world_class) continue;
    if (std::abs(found.range - beside.range) <= 2.0 * kMillimetre) return true;
    // Along a surface at a grazing angle, ranges change fast.
    if (std::abs(beside.range - range) >= std::abs(found.range - range)) return true;
  }
  return false;
}

struct Count {
  std::int64_t rays = 0;
  std::int64_t wrong = 0;
  std::int64_t by_edges = 0;  ///< unlike the judge's, because something else is within 1 mm
  double farthest = 0.0;      ///< greatest difference between ranges of the same thing [m]
};

void judge(ScannedHall& hall, const LidarModel& model, Stamp stamp, Count& count) {
  const auto frames = hall.frames();
  const Cloud cloud = test::cloudIn(hall, model, frames, stamp);
  std::map<std::pair<int, int>, const CloudPoint*> points;
  for (const CloudPoint& point : cloud.points) points[{point.column, point.ring}] = &point;
  const FiringPlan plan(model);
  Judge judge(hall);
  for (int column = 0; column < plan.columns(); ++column) {
    for (int ring = 0; ring < plan.rings(); ++ring) {
      const Duration begin = plan.columnTime(column);
      const auto passed = static_cast<double>((plan.columnTime(column + 1) - begin).count());
      const Stamp time = stamp + begin + Duration(std::llround(plan.share(ring) * passed));
      judge.setTime(time);
      const Pose X_GS = hall.driving(time);
      const Eigen::Vector3d direction = X_GS.linear() * plan.direction(column, ring);
      const Seen right = judge.look(X_GS.translation(), direction);
      Seen found;
      const auto point = points.find({column, ring});
      if (point != points.end()) {
        const CloudPoint& p = *point->second;
        found = {p.part, p.world_class, p.position_S.cast<double>().norm()};
        ASSERT_NEAR(p.time, static_cast<double>((time - stamp).count()), 1.0);
      }
      ++count.rays;
      if (areAlike(found, right)) {
        count.farthest = std::max(count.farthest, std::abs(found.range - right.range));
      } else if (isByAnEdge(judge, found, X_GS.translation(), direction,
                            std::max(found.range, right.range))) {
        ++count.by_edges;
      } else {
        ++count.wrong;
      }
    }
  }
}

/// How many sweeps of 32,768 rays are judged; SYNTHETIC_DATASET_SWEEPS=306 makes ten million rays.
int sweepCount() {
  const char* given = std::getenv("SYNTHETIC_DATASET_SWEEPS");
  return given != nullptr ? std::atoi(given) : 2;
}

TEST(SweepTruth, IsWhatEachRayMeetsAtItsOwnTime) {
  Count count;
  ScannedHall hall(16);
  for (int i = 0; i < sweepCount(); ++i) {
    judge(hall, test::exactModel(32, 1024), kSweepTime + i * std::chrono::milliseconds(7), count);
    hall = ScannedHall(16);
  }
  std::printf("%lld rays: %lld wrong, %lld by edges; ranges within %.6f m\n",
              static_cast<long long>(count.rays), static_cast<long long>(count.wrong),
              static_cast<long long>(count.by_edges), count.farthest);
  EXPECT_EQ(count.wrong, 0);
  EXPECT_LT(count.by_edges, count.rays / 1000);
}

TEST(SweepTruth, HoldsWhereRingsFireOneAfterTheOther) {
  Count count;
  ScannedHall hall(16);
  LidarModel model = *modelOf("VLP-16");
  model.noise = model.resolution = 0.0;
  judge(hall, model, kSweepTime, count);
  EXPECT_EQ(count.wrong, 0);
}

/// Expects nearly all points to be where they are in a hall at the origin with nothing around it.
void expectPointsAsAlone(ScannedHall& hall) {
  const LidarModel model = test::exactModel(8, 512);
  const auto frames = hall.frames();
  const Cloud cloud = test::cloudIn(hall, model, frames);
  ScannedHall alone_hall(16);
  const auto alone_frames = alone_hall.frames();
  const Cloud alone = test::cloudIn(alone_hall, model, alone_frames);
  std::int64_t alike = 0;
  ASSERT_NEAR(static_cast<double>(cloud.points.size()), static_cast<double>(alone.points.size()),
              4);
  for (std::size_t i = 0; i < std::min(cloud.points.size(), alone.points.size()); ++i) {
    alike += (cloud.points[i].position_S - alone.points[i].position_S).norm() < 0.001F ? 1 : 0;
  }
  EXPECT_GT(alike, static_cast<std::int64_t>(alone.points.size()) * 99 / 100);
}

TEST(SweepTruth, HoldsFarFromTheOriginOfTheWorld) {
  ScannedHall hall(16, {450'000.0, 5'400'000.0, 300.0});
  expectPointsAsAlone(hall);
}

TEST(SweepTruth, HoldsBelowSomethingThatWentAstray) {
  ScannedHall hall(16, Eigen::Vector3d::Zero(), 343'582.7);
  expectPointsAsAlone(hall);
}

}  // namespace sweep_truth_test
}  // namespace synthetic_dataset::lidar

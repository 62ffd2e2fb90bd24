#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "base/diagnostics.h"
#include "lidar/firing_plan.h"
#include "lidar/lidar_rig.h"
#include "lidar/recorded_cloud.h"
#include "lidar/scanned_world.h"
#include "lidar/sweep.h"
#include "motion/frame_source.h"
#include "synthetic_dataset/cloud.h"
#include "world/world.h"

namespace synthetic_dataset::lidar {

/// The clouds of an instant, and what the user should know about the recorded ones.
struct TakenClouds {
  Clouds clouds;
  std::vector<base::Warning> warnings;
};

/// Makes the clouds of an instant, in any thread but one at a time; further calls return the same
/// clouds.
using PendingClouds = std::function<TakenClouds()>;

/// Takes the sweeps of all lidars around an instant: casts their rays, or labels their recorded
/// clouds.
///
/// For each instant: move the world to each of `offsets` from the instant and `look`, then `take`.
/// Moving bodies are interpolated between these times; a scanner's pose is looked up for each
/// column.
class SweepTaker {
 public:
  /// @param world  before anything has moved; has to outlive this, like the other references
  /// @param labels  of the world's links
  SweepTaker(const world::World& world, const motion::FrameSource& frames,
             const std::vector<LidarRig>& lidars, std::vector<LinkLabel> labels,
             render::GlassInLabels glass, std::int64_t seed);

  /// The offsets from an instant at which the world is sampled, ascending; 0 is among them. Only 0
  /// if nothing can move.
  [[nodiscard]] std::vector<Duration> offsets(Stamp stamp) const;

  /// Sets the instant that the next calls of look() belong to.
  void begin(Stamp stamp);

  /// Remembers where everything is in the world as it stands at `offset` from the instant.
  void look(Duration offset);

  /// What the scanners measure around the instant while the world moves as look() has seen it.
  /// @param materials  of the surfaces at the time (world::Look::materials)
  [[nodiscard]] PendingClouds take(
      std::int64_t instant, const std::map<const world::Material*, world::Material>& materials);

 private:
  /// Makes one lidar's cloud of an instant, and adds what the user should know to `warnings`.
  using MakeCloud = std::function<Cloud(const Paint& paint, std::vector<base::Warning>& warnings)>;

  [[nodiscard]] base::Placement lidarAt(std::size_t lidar, const std::vector<WorldMoment>& moments,
                                        Duration offset) const;
  [[nodiscard]] MakeCloud castCloud(std::size_t lidar, std::int64_t instant,
                                    const std::vector<WorldMoment>& moments) const;
  [[nodiscard]] MakeCloud recordedCloud(std::size_t lidar,
                                        const std::vector<WorldMoment>& moments) const;

  const world::World& world_;
  const motion::FrameSource& frames_;
  const std::vector<LidarRig>& lidars_;
  std::shared_ptr<const ScannedWorld> scanned_;
  std::shared_ptr<const std::vector<LinkLabel>> labels_;
  std::size_t object_count_ = 0;
  std::uint64_t seed_;
  bool can_move_ = false;             ///< something that rays hit, or a scanner on a link
  Stamp stamp_{0};                    ///< of the instant
  std::vector<Duration> offsets_;     ///< of the instant
  std::vector<WorldMoment> moments_;  ///< of the instant, so far
};

}  // namespace synthetic_dataset::lidar

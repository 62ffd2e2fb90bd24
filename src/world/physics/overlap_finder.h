#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "synthetic_dataset/pose.h"
#include "world/physics/collision_models.h"
#include "world/world.h"

namespace synthetic_dataset::world {

/// A body at a pose.
struct StandingBody {
  const MovingCollisions* collisions = nullptr;
  Pose X_WB = Pose::Identity();
  std::string name;  ///< of its model
};

/// Finds objects that overlap one another or static models.
class OverlapFinder {
 public:
  /// @param fixed  has to outlive this
  explicit OverlapFinder(const std::vector<FixedCollision>& fixed);
  ~OverlapFinder();
  OverlapFinder(const OverlapFinder&) = delete;
  OverlapFinder& operator=(const OverlapFinder&) = delete;

  /// Each pair that overlaps by more than `tolerance` [m], once, with its deepest contact, sorted
  /// by names. Bodies with the same name belong to one object, and their overlaps are ignored.
  [[nodiscard]] std::vector<Interpenetration> find(const std::vector<StandingBody>& bodies,
                                                   double tolerance) const;

  /// The name of something that the body overlaps by more than `tolerance` [m]: a static model or
  /// one of the others; nothing if it is clear of all.
  [[nodiscard]] std::optional<std::string> obstacle(const StandingBody& body,
                                                    const std::vector<StandingBody>& others,
                                                    double tolerance) const;

  /// The same for a ball, for which any overlap counts.
  [[nodiscard]] std::optional<std::string> obstacle(const Eigen::Vector3d& centre_W, double radius,
                                                    const std::vector<StandingBody>& others) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::world

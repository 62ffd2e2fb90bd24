#include "randomize/placement/camera_sampler.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Geometry>

#include "randomize/placement/standing_place.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::randomize {
namespace {

/// A surface this close to the target does not hide it: it may be the target's own.
constexpr double kNearTarget = 0.01;  // [m]

/// A line of sight closer to the vertical than this [rad] has no usable horizontal direction.
constexpr double kVertical = 1e-9;

/// Below this distance the viewing direction is undefined [m].
constexpr double kNoDirection = 1e-9;

/// The targets that are present; all of them if none is.
std::vector<CameraTarget> presentOf(const std::vector<CameraTarget>& targets) {
  const bool some = std::any_of(targets.begin(), targets.end(),
                                [](const CameraTarget& target) { return target.is_present; });
  std::vector<CameraTarget> present;
  for (const CameraTarget& target : targets) {
    if (target.is_present || !some) present.push_back(target);
  }
  return present;
}

/// All targets together: the middle of their centres, and their mean size.
CameraTarget middleOf(const std::vector<CameraTarget>& targets) {
  CameraTarget sum;
  for (const CameraTarget& target : targets) {
    sum.centre_G += target.centre_G;
    sum.size += target.size;
  }
  const auto count = static_cast<double>(targets.size());
  return {"all", sum.centre_G / count, true, sum.size / count};
}

}  // namespace

Pose lookingAt(const Eigen::Vector3d& position_G, const Eigen::Vector3d& aim_G, double roll) {
  const Eigen::Vector3d ahead = (aim_G - position_G).normalized();
  Eigen::Vector3d right = ahead.cross(Eigen::Vector3d::UnitZ());
  if (right.norm() < kVertical) right = -Eigen::Vector3d::UnitY();
  right.normalize();
  Eigen::Matrix3d axes;  // the optical frame's: x right, y down, z ahead
  axes << right, ahead.cross(right), ahead;
  const Eigen::AngleAxisd turn(roll, Eigen::Vector3d::UnitZ());
  return makePose(position_G, Eigen::Quaterniond(axes) * turn);
}

CameraSampler::CameraSampler(CameraSampling config, std::string group, const world::World& world,
                             Surroundings& surroundings, std::uint64_t seed)
    : config_(std::move(config)),
      group_(std::move(group)),
      world_(world),
      surroundings_(surroundings),
      seed_(seed) {}

CameraTarget CameraSampler::target(base::RandomSource& source,
                                   const std::vector<CameraTarget>& targets) const {
  if (config_.look_at_point_G) return {"", *config_.look_at_point_G};
  if (config_.look_at == "any") {
    const std::vector<CameraTarget> there = presentOf(targets);
    return there[source.index(there.size())];
  }
  if (config_.look_at == "all") return middleOf(presentOf(targets));
  return *std::find_if(targets.begin(), targets.end(),
                       [&](const CameraTarget& target) { return target.name == config_.look_at; });
}

Eigen::Vector3d CameraSampler::position(base::RandomSource& source,
                                        const CameraTarget& target) const {
  if (config_.position_G) {
    const std::vector<double> place = config_.position_G->draw(source);
    return {place[0], place[1], place[2]};
  }
  const double unit = config_.is_relative_to_size ? target.size : 1.0;
  const double distance = unit * config_.distance.drawNumber(source);
  const double elevation = config_.elevation.drawNumber(source);
  const double azimuth = config_.azimuth.drawNumber(source);
  return target.centre_G + distance * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                                                      std::cos(elevation) * std::sin(azimuth),
                                                      std::sin(elevation));
}

CameraSampler::Look CameraSampler::draw(base::RandomSource& source,
                                        const std::vector<CameraTarget>& targets) const {
  const CameraTarget at = target(source, targets);
  const std::vector<double> offset = config_.aim_offset.draw(source);
  const Eigen::Vector3d position_G = position(source, at);
  const double unit = config_.is_relative_to_size ? (at.centre_G - position_G).norm() : 1.0;
  const Eigen::Vector3d aim_G =
      at.centre_G + unit * Eigen::Vector3d(offset[0], offset[1], offset[2]);
  return {at.centre_G, aim_G, position_G,
          lookingAt(position_G, aim_G, config_.roll.drawNumber(source))};
}

std::optional<std::string> CameraSampler::whyNotFree(const Look& look) const {
  if ((look.aim_G - look.position_G).norm() < kNoDirection) {
    return "would have stood where they look";
  }
  if (config_.clearance > 0.0) {
    const auto obstacle = world_.obstacleNear(look.position_G, config_.clearance);
    if (obstacle) return "were too near '" + *obstacle + "'";
  }
  return std::nullopt;
}

bool CameraSampler::seesTarget(const Look& look) const {
  const Eigen::Vector3d ahead = look.target_G - look.position_G;
  const double free = ahead.norm() - kNearTarget;
  return free <= 0.0 || !surroundings_.cast(look.position_G, ahead, free);
}

SampledPose CameraSampler::sample(std::int64_t scene,
                                  const std::vector<CameraTarget>& targets) const {
  base::RandomSource source(seed_, scene, group_ + "/sample");
  std::map<std::string, int> misses;
  std::optional<Pose> first_free;
  for (int i = 0; i < config_.tries; ++i) {
    const Look look = draw(source, targets);
    const auto reason = whyNotFree(look);
    if (!reason && seesTarget(look)) return {look.X_GC, ""};
    if (!reason && !first_free) first_free = look.X_GC;
    ++misses[reason.value_or("would not have seen what they look at")];
  }
  if (first_free) return {*first_free, reasonsText(misses)};
  throw Error(group_ + "/sample: scene " + std::to_string(scene) + ": none of " +
              std::to_string(config_.tries) + " places was free: " + reasonsText(misses) +
              "; a larger shell or box, or a smaller clearance would help");
}

}  // namespace synthetic_dataset::randomize

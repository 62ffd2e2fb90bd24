#include "randomize/placement/distractor_placer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "randomize/placement/random_place.h"

namespace synthetic_dataset::randomize {
namespace {

/// Any closer, a distractor would hide nearly everything that a camera sees.
constexpr double kFromCameras = 0.3;  // [m]

std::size_t countOf(const std::vector<std::optional<Pose>>& poses) {
  return static_cast<std::size_t>(
      std::count_if(poses.begin(), poses.end(), [](const auto& pose) { return pose.has_value(); }));
}

/// A volume around the objects, with margins proportional to the largest one.
Volume around(const std::vector<Cuboid>& objects_G) {
  constexpr double kBeside = 1.5;
  constexpr double kAbove = 1.0;
  if (objects_G.empty()) return {};
  Volume volume{objects_G.front().low, objects_G.front().high};
  double largest = 0.0;
  for (const Cuboid& box : objects_G) {
    volume.low = volume.low.cwiseMin(box.low);
    volume.high = volume.high.cwiseMax(box.high);
    largest = std::max(largest, box.size().norm());
  }
  volume.low -= largest * Eigen::Vector3d(kBeside, kBeside, 0.0);
  volume.high += largest * Eigen::Vector3d(kBeside, kBeside, kAbove);
  return volume;
}

}  // namespace

DistractorPlacer::DistractorPlacer(const DistractorOptions& config, std::vector<Cuboid> boxes_M,
                                   world::World& world, Surroundings& surroundings,
                                   std::uint64_t seed)
    : config_(config),
      boxes_M_(std::move(boxes_M)),
      world_(world),
      surroundings_(surroundings),
      seed_(seed) {}

/// Which distractors are in a scene, in ascending order.
std::vector<std::size_t> DistractorPlacer::choose(std::int64_t scene) const {
  base::RandomSource source(seed_, scene, "randomize/distractors/count");
  const auto wished = std::llround(config_.count.drawNumber(source));
  const std::size_t count = std::min(static_cast<std::size_t>(wished), boxes_M_.size());
  base::RandomSource which(seed_, scene, "randomize/distractors/which");
  std::vector<std::size_t> chosen = which.choice(count, boxes_M_.size());
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

std::vector<int> DistractorPlacer::place(std::int64_t scene,
                                         const std::vector<Eigen::Vector3d>& cameras_G,
                                         const std::vector<Cuboid>& objects_G) {
  volume_ = config_.volume ? *config_.volume : around(objects_G);
  std::vector<std::optional<Pose>> placed(boxes_M_.size());
  std::vector<int> numbers;
  for (const std::size_t i : choose(scene)) {
    placed[i] = findPlace(i, scene, placed, cameras_G);
  }
  if (config_.mode == DistractorMode::kDrop) drop(placed, cameras_G);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    if (placed[i]) numbers.push_back(static_cast<int>(i) + 1);
  }
  world_.placeDistractors(placed);
  return numbers;
}

/// Drops all distractors together. Any that have not come to rest, or would hide a camera's view,
/// are removed; then whatever lay on them falls as well.
void DistractorPlacer::drop(std::vector<std::optional<Pose>>& X_GM,
                            const std::vector<Eigen::Vector3d>& cameras_G) const {
  const auto time =
      std::chrono::duration_cast<Duration>(std::chrono::duration<double>(config_.fall_time));
  for (bool all_stay = false; !all_stay;) {
    const std::size_t before = countOf(X_GM);
    X_GM = world_.dropDistractors(X_GM, time);
    for (std::size_t i = 0; i < X_GM.size(); ++i) {
      if (X_GM[i] && isNearAny(cameras_G, i, *X_GM[i])) X_GM[i].reset();
    }
    all_stay = countOf(X_GM) == before;
  }
}

std::optional<Pose> DistractorPlacer::findPlace(
    std::size_t distractor, std::int64_t scene, const std::vector<std::optional<Pose>>& placed,
    const std::vector<Eigen::Vector3d>& cameras_G) const {
  base::RandomSource source(seed_, scene,
                            "randomize/distractors/" + std::to_string(distractor + 1));
  for (int i = 0; i < config_.tries; ++i) {
    const PoseOrReason drawn = draw(distractor, source);
    const auto* X_GM = std::get_if<Pose>(&drawn);
    if (X_GM == nullptr || isNearAny(cameras_G, distractor, *X_GM)) continue;
    if (!world_.obstacleOfDistractor(distractor, *X_GM, placed)) return *X_GM;
  }
  return std::nullopt;
}

bool DistractorPlacer::isNearAny(const std::vector<Eigen::Vector3d>& cameras_G,
                                 std::size_t distractor, const Pose& X_GM) const {
  const Cuboid& box = boxes_M_[distractor];
  const Eigen::Vector3d centre_G = X_GM * Eigen::Vector3d(0.5 * (box.low + box.high));
  const double nearest = 0.5 * (box.high - box.low).norm() + kFromCameras;
  return std::any_of(cameras_G.begin(), cameras_G.end(), [&](const Eigen::Vector3d& camera_G) {
    return (camera_G - centre_G).norm() < nearest;
  });
}

PoseOrReason DistractorPlacer::draw(std::size_t distractor, base::RandomSource& source) const {
  const Eigen::Vector3d position = drawWithin(volume_, source);
  if (config_.mode != DistractorMode::kStand) {
    return makePose(position, Eigen::Quaterniond(source.orientation()));
  }
  SurfaceOptions surface;
  surface.highest = volume_.high.z();
  const StandingPlace stand(surroundings_, surface);
  return stand.at(position.head<2>(), source.angle(), boxes_M_[distractor]);
}

}  // namespace synthetic_dataset::randomize

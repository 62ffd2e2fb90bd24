#include "randomize/placement/scene_placer.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <Eigen/Geometry>

#include "randomize/placement/object_row.h"
#include "randomize/placement/random_place.h"
#include "randomize/placement/standing_place.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::randomize {
namespace {

/// How often all objects of a scene are placed anew if the first ones leave no place for the last,
/// or something dropped has not come to rest.
constexpr int kMostAttempts = 10;

std::string noPlaceOnMap(const PlacedObject& object, double radius, double largest) {
  return "placement/map: no place for '" + object.name + "': " + object.name +
         "/safety_radius is " + fixed(radius, 3) +
         " m, and the map has no free place that is farther than " + fixed(largest, 3) +
         " m from all that is not free";
}

}  // namespace

ScenePlacer::ScenePlacer(const PlacementOptions& config, const std::optional<OccupancyMap>& map,
                         std::vector<PlacedObject> objects, world::World& world,
                         Surroundings& surroundings, std::uint64_t seed)
    : config_(config), objects_(std::move(objects)), world_(world), seed_(seed) {
  if (config_.mode == PlacementMode::kGround) stand_.emplace(surroundings, config_.surface);
  if (config_.mode != PlacementMode::kMap) return;
  std::vector<std::string> errors;
  for (const PlacedObject& object : objects_) {
    if (!object.takes_part) continue;
    double greatest = 0.0;
    for (const NeededRoom& room : object.rooms) {
      const double radius = room.safety_radius;
      if (free_.count(radius) == 0) free_.emplace(radius, FreePlaces(*map, radius));
      greatest = std::max(greatest, radius);
    }
    if (free_.at(greatest).cellCount() > 0) continue;
    errors.push_back(noPlaceOnMap(object, greatest, largestClearance(*map)));
  }
  if (!errors.empty()) throw ErrorList(std::move(errors));
  if (config_.on_surface) {
    stand_.emplace(surroundings, config_.surface);
  }
}

std::vector<std::optional<Pose>> ScenePlacer::place(std::int64_t scene) {
  std::vector<base::RandomSource> sources;
  for (const PlacedObject& object : objects_) {
    sources.emplace_back(seed_, scene, "placement/" + object.name);
  }
  const auto fall_time =
      std::chrono::duration_cast<Duration>(std::chrono::duration<double>(config_.fall_time));
  const bool drops = config_.mode == PlacementMode::kDrop;
  const std::optional<ObjectRow> row = drawRow(scene);
  std::string problem;
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    world_.restart();
    auto poses = placeAll(row, sources, problem);
    if (poses && drops) {
      poses = world_.drop(*poses, fall_time);
      problem = "what was dropped had not come to rest after placement/fall_time of " +
                fixed(config_.fall_time, 1) + " s (does something fall past the floor?)";
    }
    if (poses) return *poses;
  }
  throw Error("placement: scene " + std::to_string(scene) + ", tried " +
              std::to_string(kMostAttempts) + " times: " + problem);
}

/// Nothing if the scene has no row.
std::optional<ObjectRow> ScenePlacer::drawRow(std::int64_t scene) const {
  if (config_.rows <= 0.0) return std::nullopt;
  base::RandomSource source(seed_, scene, "placement/rows");
  if (source.unit() >= config_.rows) return std::nullopt;
  std::size_t count = 0;
  double widest = 0.0;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    if (!isInRow(i)) continue;
    ++count;
    widest = std::max(widest, roomOf(i).box_O.size().head<2>().maxCoeff());
  }
  if (count < 2) return std::nullopt;
  return ObjectRow(config_.volume, widest, count, source);
}

/// Places each object in the row if its place there is free, otherwise anywhere.
std::optional<ScenePlacer::Poses> ScenePlacer::placeAll(const std::optional<ObjectRow>& row,
                                                        std::vector<base::RandomSource>& sources,
                                                        std::string& problem) const {
  Poses placed;
  std::size_t number = 0;  // in the row
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    if (!objects_[i].takes_part) {
      placed.emplace_back();
      continue;
    }
    Misses misses;
    auto X_GO = row && isInRow(i) ? row->place(number++, sources[i]) : std::nullopt;
    if (!X_GO || whyNot(i, *X_GO, placed)) X_GO = findPlace(i, sources[i], placed, misses);
    if (!X_GO) {
      problem = "no place for '" + objects_[i].name + "' among " + std::to_string(config_.tries) +
                " (placement/tries): " + reasonsText(misses);
      return std::nullopt;
    }
    placed.push_back(X_GO);
  }
  return placed;
}

std::optional<Pose> ScenePlacer::findPlace(std::size_t object, base::RandomSource& source,
                                           const Poses& placed, Misses& misses) const {
  for (int i = 0; i < config_.tries; ++i) {
    const PoseOrReason drawn = draw(object, source);
    if (const auto* reason = std::get_if<std::string>(&drawn)) {
      ++misses[*reason];
      continue;
    }
    const Pose& X_GO = std::get<Pose>(drawn);
    const auto reason = whyNot(object, X_GO, placed);
    if (!reason) return X_GO;
    ++misses[*reason];
  }
  return std::nullopt;
}

bool ScenePlacer::isInRow(std::size_t object) const {
  return objects_[object].takes_part && world_.isPresent(object);
}

/// The room for the object's current variant.
const NeededRoom& ScenePlacer::roomOf(std::size_t object) const {
  return objects_[object].rooms[world_.variant(object)];
}

PoseOrReason ScenePlacer::draw(std::size_t object, base::RandomSource& source) const {
  switch (config_.mode) {
    case PlacementMode::kMap:
      return drawOnMap(object, source);
    case PlacementMode::kGround:
      return drawOnGround(object, source);
    case PlacementMode::kVolume:
    case PlacementMode::kDrop:
      break;
  }
  return drawInVolume(source);
}

PoseOrReason ScenePlacer::drawOnMap(std::size_t object, base::RandomSource& source) const {
  const NeededRoom& room = roomOf(object);
  const auto place = free_.at(room.safety_radius).draw(source, 1);
  if (!place) return "were nearer than safety_radius to what is not free";
  const double heading = source.angle();
  if (stand_) return stand_->at(*place, heading, room.box_O);
  const Eigen::AngleAxisd turn(heading, Eigen::Vector3d::UnitZ());
  return makePose({place->x(), place->y(), config_.height}, Eigen::Quaterniond(turn));
}

PoseOrReason ScenePlacer::drawOnGround(std::size_t object, base::RandomSource& source) const {
  const Eigen::Vector2d& low = config_.area->low;
  const Eigen::Vector2d& high = config_.area->high;
  const double x = source.uniform(low.x(), high.x());
  const double y = source.uniform(low.y(), high.y());
  return stand_->at({x, y}, source.angle(), roomOf(object).box_O);
}

Pose ScenePlacer::drawInVolume(base::RandomSource& source) const {
  const Eigen::Vector3d position = drawWithin(config_.volume, source);
  const Eigen::AngleAxisd turn(source.angle(), Eigen::Vector3d::UnitZ());
  return makePose(position, config_.upright ? Eigen::Quaterniond(turn)
                                            : Eigen::Quaterniond(source.orientation()));
}

std::optional<std::string> ScenePlacer::whyNot(std::size_t object, const Pose& X_GO,
                                               const Poses& placed) const {
  const double radius = roomOf(object).safety_radius;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    if (!placed[i]) continue;
    Eigen::Vector3d apart = placed[i]->translation() - X_GO.translation();
    if (stand_ || config_.mode == PlacementMode::kMap) apart.z() = 0.0;  // as seen from above
    if (apart.norm() < radius + roomOf(i).safety_radius) {
      return "were too near '" + objects_[i].name + "'";
    }
  }
  const auto obstacle = world_.obstacleAt(static_cast<int>(object), X_GO, placed);
  if (obstacle) return "were inside '" + *obstacle + "'";
  return std::nullopt;
}

}  // namespace synthetic_dataset::randomize

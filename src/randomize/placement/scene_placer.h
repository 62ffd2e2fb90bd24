#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/random/random_source.h"
#include "randomize/placement/free_places.h"
#include "randomize/placement/object_row.h"
#include "randomize/placement/occupancy_map.h"
#include "randomize/placement/placement_options.h"
#include "randomize/placement/standing_place.h"
#include "synthetic_dataset/cuboid.h"
#include "synthetic_dataset/pose.h"
#include "world/world.h"

namespace synthetic_dataset::randomize {

/// The space that something needs.
struct NeededRoom {
  double safety_radius = 0.0;  ///< about its frame's origin; nothing else comes closer [m]
  Cuboid box_O;                ///< around it
};

/// Something to be placed.
struct PlacedObject {
  std::string name;
  std::vector<NeededRoom> rooms;  ///< one for each of its variants
  bool takes_part = true;         ///< otherwise it is not placed at all
};

/// Places objects at random in each scene: on the free places of a map as the paper's first version
/// did (Hart, Goodman, O'Shea), anywhere on the ground, anywhere in a box, or dropped from there.
/// Nothing is ever inside anything else.
///
/// The result depends only on the seed, the scene and the objects. Each object is drawn
/// independently of the others, except for rows and for what is in the way.
class ScenePlacer {
 public:
  /// @param config  must have an area if its mode is kGround
  /// @param map  if the mode needs one
  /// @param objects  in the world's order
  /// @param world  must outlive this, and so must its surroundings
  /// @throws ErrorList naming each object for which the map has no place
  ScenePlacer(const PlacementOptions& config, const std::optional<OccupancyMap>& map,
              std::vector<PlacedObject> objects, world::World& world, Surroundings& surroundings,
              std::uint64_t seed);

  /// X_GO of all objects in a scene, in their active variants; resets the world.
  /// @return nothing for objects that do not take part
  /// @throws Error naming an object for which no place was found, and saying why
  [[nodiscard]] std::vector<std::optional<Pose>> place(std::int64_t scene);

 private:
  using Misses = std::map<std::string, int>;  ///< number of rejected places by reason
  using Poses = std::vector<std::optional<Pose>>;

  [[nodiscard]] const NeededRoom& roomOf(std::size_t object) const;
  [[nodiscard]] PoseOrReason draw(std::size_t object, base::RandomSource& source) const;
  [[nodiscard]] PoseOrReason drawOnMap(std::size_t object, base::RandomSource& source) const;
  [[nodiscard]] PoseOrReason drawOnGround(std::size_t object, base::RandomSource& source) const;
  [[nodiscard]] Pose drawInVolume(base::RandomSource& source) const;
  [[nodiscard]] std::optional<std::string> whyNot(std::size_t object, const Pose& X_GO,
                                                  const Poses& placed) const;
  [[nodiscard]] bool isInRow(std::size_t object) const;
  [[nodiscard]] std::optional<ObjectRow> drawRow(std::int64_t scene) const;
  [[nodiscard]] std::optional<Pose> findPlace(std::size_t object, base::RandomSource& source,
                                              const Poses& placed, Misses& misses) const;
  [[nodiscard]] std::optional<Poses> placeAll(const std::optional<ObjectRow>& row,
                                              std::vector<base::RandomSource>& sources,
                                              std::string& problem) const;

  PlacementOptions config_;
  std::vector<PlacedObject> objects_;
  world::World& world_;
  std::uint64_t seed_;
  std::map<double, FreePlaces> free_;   ///< by safety radius, with a map
  std::optional<StandingPlace> stand_;  ///< if objects stand on what is below
};

}  // namespace synthetic_dataset::randomize

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/random/distribution.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::randomize {

/// Bullet needs two seconds of stillness before it considers something to be at rest.
constexpr double kShortestFall = 2.5;  // [s]

/// Where objects may be put.
enum class PlacementMode {
  kMap,     ///< on the free places of an occupancy map
  kGround,  ///< on whatever is there, anywhere in a rectangle
  kVolume,  ///< anywhere in a box, in any orientation
  kDrop,    ///< dropped from anywhere in a box until they come to rest
};

/// A box aligned with the axes of the global frame [m].
struct Volume {
  Eigen::Vector3d low{0, 0, 0};
  Eigen::Vector3d high{0, 0, 0};
};

/// A rectangle aligned with the axes of the global frame, as seen from above [m].
struct GroundArea {
  Eigen::Vector2d low{0, 0};
  Eigen::Vector2d high{0, 0};
};

/// Properties that a surface must have for something to stand on it.
struct SurfaceOptions {
  double highest = 2.0;      ///< anything above it in the global frame is ignored [m]
  double steepest = 0.35;    ///< [rad] from the horizontal
  double unevenness = 0.05;  ///< how far below or above its plane the surface may be at the corners
                             ///< of what stands on it [m]
};

/// How objects are placed at random, anew for each scene.
struct PlacementOptions {
  PlacementMode mode = PlacementMode::kMap;
  std::optional<std::string> map_file;   ///< map_server's YAML; absolute
  std::optional<std::string> map_topic;  ///< in the bag, or of a running system
  std::optional<Value> received_map;     ///< what the topic has sent: see received_map.h
  bool on_surface = true;                ///< for kMap: on what is below; otherwise at `height`
  double height = 0.0;                   ///< of the objects' frames in the global frame [m]
  SurfaceOptions surface;                ///< for kMap and kGround
  std::optional<GroundArea> area;        ///< for kGround; if none, all that stands still in the
                                         ///< world
  Volume volume;                         ///< for kVolume and kDrop
  bool upright = false;                  ///< for kVolume and kDrop: rotated only about the vertical
  double rows = 0.0;                     ///< for kVolume and kDrop: the share of scenes in which
                                         ///< objects stand in a row, 0 .. 1
  double fall_time = 10.0;               ///< [s] in which dropped objects must come to rest
  int tries = 1000;                      ///< for each object in each scene
};

/// How distractors are placed.
enum class DistractorMode {
  kFly,    ///< anywhere in the volume, in any orientation
  kStand,  ///< upright on whatever is below
  kDrop,   ///< at rest after falling from there
};

/// Things that stand, lie or fly about, so that a network does not take everything that stands out
/// for an object.
struct DistractorOptions {
  int pool = 24;  ///< number of different ones, made once for the run
  base::Distribution count = base::Distribution::uniform({0.0}, {8.0});     ///< in a scene
  base::Distribution size = base::Distribution::logUniform({0.08}, {0.4});  ///< of a side [m]
  std::vector<std::string> models;       ///< URIs or paths of models, or of folders that hold some;
                                         ///< if empty: boxes, balls and cylinders
  std::vector<Eigen::Vector3d> colours;  ///< sRGB-encoded, 0 .. 1: some of those have one of these
                                         ///< instead of a texture
  std::string textures = "procedural";   ///< for the others; or an absolute folder, or `none`
  DistractorMode mode = DistractorMode::kFly;
  double fall_time = 10.0;       ///< [s] in which dropped ones must come to rest to be kept
  std::optional<Volume> volume;  ///< where they are, or above which they are placed, or from which
                                 ///< they fall; if none, around the objects
  std::optional<std::string> label_class;  ///< for all of them, as text; if none, they are not
                                           ///< labelled
  int tries = 50;  ///< for each; one without a place is left out of the scene
};

/// The name of a distractor in a run: "distractor_1" is number 1.
[[nodiscard]] inline std::string distractorName(int number) {
  return "distractor_" + std::to_string(number);
}

/// How a camera is placed at random, anew for each scene.
struct CameraSampling {
  /// What it looks at: an object's name, `any` (one of the objects, drawn for each scene) or `all`
  /// (the middle of all). Ignored if there is a point.
  std::string look_at = "any";
  std::optional<Eigen::Vector3d> look_at_point_G;

  /// Whether lengths are relative to the target instead of in metres: `distance` in multiples of
  /// its size (the diagonal of its cuboid), `aim_offset` in multiples of that distance. A point has
  /// no size.
  bool is_relative_to_size = false;

  /// Offset from the target along the global frame's axes [m].
  base::Distribution aim_offset = base::Distribution::constant({0, 0, 0});

  /// Position relative to the target, on a shell around it, unless `position_G` is set.
  base::Distribution distance = base::Distribution::uniform({1.0}, {3.0});   ///< [m]
  base::Distribution elevation = base::Distribution::uniform({0.2}, {1.0});  ///< [rad]
  base::Distribution azimuth =
      base::Distribution::uniform({-3.141592653589793}, {3.141592653589793});  ///< [rad]

  /// Position in a box of the global frame instead [m].
  std::optional<base::Distribution> position_G;

  base::Distribution roll = base::Distribution::constant({0.0});  ///< [rad]
  double clearance = 0.1;                                         ///< from everything there [m]
  int tries = 1000;
};

}  // namespace synthetic_dataset::randomize

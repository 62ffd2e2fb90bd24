#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/random/distribution.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::randomize {

/// Bullet needs two seconds of stillness before something counts as lying.
constexpr double kShortestFall = 2.5;  // [s]

/// Where objects may be put.
enum class PlacementMode {
  kMap,     ///< on the free places of an occupancy map
  kGround,  ///< on what is there, anywhere in a rectangle
  kVolume,  ///< anywhere in a box, in any orientation
  kDrop,    ///< from there, until they have fallen and come to rest
};

/// A box along the axes of the global frame [m].
struct Volume {
  Eigen::Vector3d low{0, 0, 0};
  Eigen::Vector3d high{0, 0, 0};
};

/// A rectangle along the axes of the global frame, as seen from above [m].
struct GroundArea {
  Eigen::Vector2d low{0, 0};
  Eigen::Vector2d high{0, 0};
};

/// What a surface has to be like for a thing to stand on it.
struct SurfaceOptions {
  double highest = 2.0;      ///< what is above it in the global frame counts for nothing [m]
  double steepest = 0.35;    ///< [rad] from the horizontal
  double unevenness = 0.05;  ///< how far below or above the surface's plane it may lie at the
                             ///< corners of what stands on it [m]
};

/// How objects are put somewhere at random, anew for each scene.
struct PlacementOptions {
  PlacementMode mode = PlacementMode::kMap;
  std::optional<std::string> map_file;   ///< map_server's YAML; absolute
  std::optional<std::string> map_topic;  ///< of the bag, or of a running system
  std::optional<Value> received_map;     ///< what that has sent: see received_map.h
  bool on_surface = true;                ///< of kMap: on what is below; else at `height`
  double height = 0.0;                   ///< of the objects' frames in the global frame [m]
  SurfaceOptions surface;                ///< of kMap and kGround
  std::optional<GroundArea> area;        ///< of kGround; none: all that stands still in the world
  Volume volume;                         ///< of kVolume and kDrop
  bool upright = false;                  ///< of kVolume and kDrop: turned about the vertical alone
  double rows = 0.0;                     ///< of kVolume and kDrop: in how many scenes objects
                                         ///< stand in a row, 0 .. 1
  double fall_time = 10.0;               ///< [s] in which what is dropped has to come to rest
  int tries = 1000;                      ///< for each object in each scene
};

/// How distractors are put somewhere.
enum class DistractorMode {
  kFly,    ///< anywhere in the volume, in any orientation
  kStand,  ///< upright on what is below
  kDrop,   ///< as they lie when they have fallen from there
};

/// Things that stand, lie or fly about, so that a network does not take all that
/// stands out for an object.
struct DistractorOptions {
  int pool = 24;  ///< different ones, made once for the run
  base::Distribution count = base::Distribution::uniform({0.0}, {8.0});     ///< in a scene
  base::Distribution size = base::Distribution::logUniform({0.08}, {0.4});  ///< of a side [m]
  std::vector<std::string> models;       ///< URIs or paths of models, or of folders that hold some;
                                         ///< empty: boxes, balls and cylinders
  std::vector<Eigen::Vector3d> colours;  ///< sRGB-encoded, 0 .. 1: some have one of these, and no
                                         ///< texture
  std::string textures = "procedural";   ///< of those; or an absolute folder, or `none`
  DistractorMode mode = DistractorMode::kFly;
  double fall_time = 10.0;  ///< [s] in which those that are dropped come to rest, or are left out
  std::optional<Volume> volume;  ///< where they are, or above where, or from where they fall;
                                 ///< nothing: around the objects
  std::optional<std::string> label_class;  ///< of all of them, as text; nothing: they have no label
  int tries = 50;  ///< for each; one without a place is left out of the scene
};

/// What a run calls its distractors: "distractor_1" is number 1.
[[nodiscard]] inline std::string distractorName(int number) {
  return "distractor_" + std::to_string(number);
}

/// How a camera is put somewhere at random, anew for each scene.
struct CameraSampling {
  /// What it looks at: an object's name, `any` (one of the objects, drawn for each scene) or `all`
  /// (the middle of all). Not used where there is a point.
  std::string look_at = "any";
  std::optional<Eigen::Vector3d> look_at_point_G;

  /// Whether lengths are those of what it looks at instead of metres: `distance` times its size
  /// (the diagonal of its cuboid), `aim_offset` times that distance. A point has no size.
  bool is_in_sizes = false;

  /// Past what it looks at, along the global frame's axes [m].
  base::Distribution aim_offset = base::Distribution::constant({0, 0, 0});

  /// Where it is, seen from what it looks at, on a shell around it; or
  base::Distribution distance = base::Distribution::uniform({1.0}, {3.0});   ///< [m]
  base::Distribution elevation = base::Distribution::uniform({0.2}, {1.0});  ///< [rad]
  base::Distribution azimuth =
      base::Distribution::uniform({-3.141592653589793}, {3.141592653589793});  ///< [rad]

  /// in a box of the global frame [m].
  std::optional<base::Distribution> position_G;

  base::Distribution roll = base::Distribution::constant({0.0});  ///< [rad]
  double clearance = 0.1;                                         ///< from all that is there [m]
  int tries = 1000;
};

}  // namespace synthetic_dataset::randomize

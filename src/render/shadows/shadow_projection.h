#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "render/parts/bounds.h"
#include "render/render_options.h"
#include "render/view.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// How far above itself a surface is compared with a shadow map, in sizes of a texel: this much,
/// and this much more where light grazes it.
inline constexpr double kShadowRaise = 0.6;
inline constexpr double kGrazingShadowRaise = 2.2;

/// The same where edges are soft: how surfaces go on is known there.
inline constexpr double kSoftShadowRaise = 0.4;

/// Soft edges grow up to this much on each side [texel].
inline constexpr double kWidestSoftness = 12.0;

/// How many shadow maps a point light has, each of a direction.
inline constexpr int kCubeSides = 6;

/// The lights that light most, by their indices in ascending order; directional ones first of all.
[[nodiscard]] std::vector<std::size_t> strongestLights(const std::vector<world::Light>& lights,
                                                       std::size_t most);

/// As many lights light what one can see through at most, which OpenGL does.
inline constexpr std::size_t kMostOnGlass = 256;

/// How many shadow maps lights take, and how large they are.
struct ShadowLayout {
  int maps = 0;       ///< of directional and spot lights, one each
  int map_size = 1;   ///< of such a map's side [texel]
  int sides = 0;      ///< of point lights, six each: the sides of a cube
  int side_size = 1;  ///< [texel]

  /// The first map of each light, -1 for those that cast no shadow. Sides come after maps.
  std::vector<int> first_maps;
};

/// @param size  of a map's side [texel], where there are few of them; more share the texels of four
/// @param detail  point lights cast shadows in full light alone
[[nodiscard]] ShadowLayout shadowLayout(const std::vector<world::Light>& lights, int size,
                                        LightDetail detail);

/// How one shadow map is made and read.
struct ShadowProjection {
  int light = 0;         ///< index in the description's lights
  int map = 0;           ///< as ShadowLayout counts them
  bool is_side = false;  ///< of a point light's cube
  int size = 1;          ///< of the map's side [texel]
  Eigen::Matrix4d shadow_from_world = Eigen::Matrix4d::Identity();
  double texel = 0.0;  ///< a texel's size [m], for spot and point lights at a distance of 1 m

  /// By how many columns and rows the shadow's edge is soft on each side, for each unit of depth
  /// between what casts it and the surface; 0 for edges as in Gazebo.
  Eigen::Vector2d softness = Eigen::Vector2d::Zero();
};

/// The lights that cast shadows, each with projections that hold what the views may see shaded.
/// @param views  those that are put together to one picture, so that they share its shadows
/// @param casters  in the world, around all that casts shadows; nothing casts where it is empty
/// @param shadow_distance  from the camera up to which directional shadows are drawn [m]
/// @param layout  of these lights
/// @param detail  with full light, lights have a size, and so shadows soft edges
[[nodiscard]] std::vector<ShadowProjection> shadowProjections(
    const std::vector<world::Light>& lights, const std::vector<View>& views, const Bounds& casters,
    double shadow_distance, const ShadowLayout& layout, LightDetail detail);

/// What the user should know: which lights should cast shadows and do not, and of which there are
/// too many.
[[nodiscard]] std::vector<std::string> lightNotes(const std::vector<world::Light>& lights,
                                                  LightDetail detail);

}  // namespace synthetic_dataset::render

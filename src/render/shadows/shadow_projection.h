#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "render/parts/bounds.h"
#include "render/render_options.h"
#include "render/view.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// How far a surface is raised above itself before it is compared with a shadow map [texel]: the
/// first always, and up to the second in addition where light grazes it.
inline constexpr double kShadowRaise = 0.6;
inline constexpr double kGrazingShadowRaise = 2.2;

/// The same for soft edges, for which surfaces' slopes in the map are known.
inline constexpr double kSoftShadowRaise = 0.4;

/// Soft edges grow up to this much on each side [texel].
inline constexpr double kWidestSoftness = 12.0;

/// The number of shadow maps of a point light, one for each direction.
inline constexpr int kCubeSides = 6;

/// The indices of the strongest lights, in ascending order; directional lights are preferred.
[[nodiscard]] std::vector<std::size_t> strongestLights(const std::vector<world::Light>& lights,
                                                       std::size_t most);

/// The maximum number of lights that light see-through surfaces, which OpenGL draws.
inline constexpr std::size_t kMostOnGlass = 256;

/// How many shadow maps the lights need, and how large they are.
struct ShadowLayout {
  int maps = 0;       ///< of directional and spot lights, one each
  int map_size = 1;   ///< side length of such a map [texel]
  int sides = 0;      ///< of point lights, six each: the sides of a cube
  int side_size = 1;  ///< [texel]

  /// The first map of each light, -1 for those that cast no shadow. Sides come after maps.
  std::vector<int> first_maps;
};

/// @param size  side length of a map [texel] if there are few of them; more than four share the
///     texels of four
/// @param detail  point lights cast shadows only with full detail
[[nodiscard]] ShadowLayout shadowLayout(const std::vector<world::Light>& lights, int size,
                                        LightDetail detail);

/// How one shadow map is made and read.
struct ShadowProjection {
  int light = 0;         ///< index in the description's lights
  int map = 0;           ///< as ShadowLayout counts them
  bool is_side = false;  ///< of a point light's cube
  int size = 1;          ///< side length of the map [texel]
  Eigen::Matrix4d shadow_from_world = Eigen::Matrix4d::Identity();
  double texel = 0.0;  ///< a texel's size [m], for spot and point lights at a distance of 1 m

  /// By how many columns and rows the shadow's edge is soft on each side, per unit of depth between
  /// the caster and the surface; 0 for edges as in Gazebo.
  Eigen::Vector2d softness = Eigen::Vector2d::Zero();
};

/// The projections of all lights that cast shadows; they contain whatever the views may see shaded.
/// @param views  those that are combined into one picture, so that they share its shadows
/// @param casters  bounds in the world of all casters; if they are empty, nothing casts shadows
/// @param shadow_distance  from the camera up to which directional shadows are drawn [m]
/// @param layout  of these lights
/// @param detail  with full detail, lights have a size, and shadows therefore soft edges
[[nodiscard]] std::vector<ShadowProjection> shadowProjections(
    const std::vector<world::Light>& lights, const std::vector<View>& views, const Bounds& casters,
    double shadow_distance, const ShadowLayout& layout, LightDetail detail);

/// What the user should know: which lights should cast shadows but do not, and whether there are
/// too many lights.
[[nodiscard]] std::vector<std::string> lightNotes(const std::vector<world::Light>& lights,
                                                  LightDetail detail);

}  // namespace synthetic_dataset::render

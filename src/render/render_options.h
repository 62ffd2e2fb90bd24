#pragma once

namespace synthetic_dataset::render {

/// Which see-through surfaces the labels show: in masks, depth and everything derived from them,
/// these surfaces hide what is behind them.
enum class GlassInLabels {
  kOfObjects,  ///< a robot's windows are part of it; the world's are looked through
  kSolid,      ///< all
  kClear,      ///< none
};

/// How much detail the lighting has.
enum class LightDetail {
  kSimple,  ///< as in Gazebo: ambient light is the same on all surfaces
  kFull,  ///< nearby surfaces occlude ambient light; lights have a size, point lights cast shadows
};

struct RenderOptions {
  int samples = 4;                ///< of pixels at an edge, 1 or 4
  int shadow_map_size = 2048;     ///< [texel]
  double shadow_distance = 50.0;  ///< [m] from the camera; up to it, sunlight casts shadows
  GlassInLabels glass_in_labels = GlassInLabels::kOfObjects;
  bool reuse = true;  ///< keeps what has not changed between pictures; affects speed only
  LightDetail light = LightDetail::kSimple;
};

}  // namespace synthetic_dataset::render

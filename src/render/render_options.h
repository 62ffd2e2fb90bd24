#pragma once

namespace synthetic_dataset::render {

/// Which surfaces that one can see through labels show: in masks, depth and all that follows from
/// them, what is behind these is hidden.
enum class GlassInLabels {
  kOfObjects,  ///< a robot's windows are part of it; through the world's one sees
  kSolid,      ///< all
  kClear,      ///< none
};

/// How much of the light is worked out.
enum class LightDetail {
  kSimple,  ///< as in Gazebo: what is everywhere is the same on all surfaces
  kFull,  ///< less of it reaches what others are near; lights have a size, and points cast shadows
};

struct RenderOptions {
  int samples = 4;                ///< of pixels by an edge, 1 or 4
  int shadow_map_size = 2048;     ///< [texel]
  double shadow_distance = 50.0;  ///< [m] from the camera; sunlight casts shadows up to it
  GlassInLabels glass_in_labels = GlassInLabels::kOfObjects;
  bool reuse = true;  ///< keeps what has not changed from picture to picture: faster, nothing else
  LightDetail light = LightDetail::kSimple;
};

}  // namespace synthetic_dataset::render

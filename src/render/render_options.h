#pragma once

namespace synthetic_dataset::render {

struct RenderOptions {
  int samples = 4;                ///< of pixels by an edge, 1 or 4
  int shadow_map_size = 2048;     ///< [texel]
  double shadow_distance = 50.0;  ///< [m] from the camera; sunlight casts shadows up to it
  bool reuse = true;  ///< keeps what has not changed from picture to picture: faster, nothing else
};

}  // namespace synthetic_dataset::render

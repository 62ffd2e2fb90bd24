#pragma once

#include <vector>

#include "render/gl_object.h"

namespace synthetic_dataset::render {

/// Depth as lights see it: one layer a light that casts shadows.
class ShadowMaps {
 public:
  /// @param size  of a layer's side [texel]
  ShadowMaps(const GlFunctions& gl, int size, int layers);

  /// Binds a layer and clears it; what is drawn then casts the light's shadows.
  void begin(int layer) const;

  [[nodiscard]] GLuint texture() const { return depth_.name(); }

 private:
  const GlFunctions& gl_;
  int size_;
  GlTexture depth_;
  std::vector<GlFramebuffer> layers_;
};

}  // namespace synthetic_dataset::render

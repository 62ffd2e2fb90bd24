#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "render/gl_object.h"

namespace synthetic_dataset::render {

/// Depth as lights see it: one layer a light that casts shadows.
class ShadowMaps {
 public:
  /// @param size  of a layer's side [texel]
  ShadowMaps(const GlFunctions& gl, int size, int layers);

  /// Binds a layer and clears it; what is drawn then casts the light's shadows.
  void begin(int layer) const;

  /// Keeps a layer as it is now.
  void keep(int layer);

  /// Binds a layer; what is drawn then casts shadows, too.
  /// @param changed  the texels [column, row] that are made again as they were kept
  void beginKept(int layer, const std::vector<Eigen::AlignedBox2i>& changed) const;

  /// All texels of a layer: the last ones are inside.
  [[nodiscard]] Eigen::AlignedBox2i whole() const;

  [[nodiscard]] GLuint texture() const { return depth_.name(); }

 private:
  void bind(int layer) const;
  void copy(const GlTexture& from, const GlTexture& to, int layer,
            const Eigen::AlignedBox2i& texels) const;

  const GlFunctions& gl_;
  int size_;
  int layer_count_;
  GlTexture depth_;
  GlTexture kept_;  ///< none until a layer is kept
  std::vector<GlFramebuffer> layers_;
};

}  // namespace synthetic_dataset::render

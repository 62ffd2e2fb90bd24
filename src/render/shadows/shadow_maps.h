#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/gl/gl_object.h"

namespace synthetic_dataset::render {

/// Depth as seen by lights: one layer for each shadow map.
class ShadowMaps {
 public:
  /// @param size  of a layer's side [texel]
  ShadowMaps(const GlFunctions& gl, int size, int layers);

  /// Binds a layer and clears it; what is drawn then casts the light's shadows.
  void begin(int layer) const;

  /// Like begin(), for a layer in which only some texels (columns and rows) are not clear.
  void beginAgain(int layer, const std::vector<cv::Rect>& changed) const;

  /// Saves a layer as it is now.
  void keep(int layer);

  /// Binds a layer as it was saved by keep(); what is drawn then casts shadows, too.
  /// @param changed  the texels to restore, as all others are unchanged
  void beginKept(int layer, const std::vector<cv::Rect>& changed) const;

  /// @param texels  columns and rows of a layer
  /// @return CV_32FC1, the texels' depths
  [[nodiscard]] cv::Mat read(int layer, const cv::Rect& texels) const;

  /// All texels of a layer.
  [[nodiscard]] cv::Rect whole() const { return {0, 0, size_, size_}; }

  [[nodiscard]] GLuint texture() const { return depth_.name(); }

 private:
  void bind(int layer) const;
  void copy(const GlTexture& from, const GlTexture& to, int layer, const cv::Rect& texels) const;

  const GlFunctions& gl_;
  int size_;
  int layer_count_;
  GlTexture depth_;
  GlTexture kept_;                     ///< empty until a layer is kept
  std::vector<GlFramebuffer> layers_;  ///< of depth_
};

}  // namespace synthetic_dataset::render

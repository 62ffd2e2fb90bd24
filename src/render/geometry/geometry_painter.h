#pragma once

#include "render/geometry/geometry_images.h"
#include "render/geometry/silhouette_bits.h"
#include "render/parts/draw_list.h"
#include "render/parts/shader_family.h"
#include "render/view.h"

namespace synthetic_dataset::render {

/// Draws surfaces, unlit, into the bound geometry buffer. Of coincident surfaces the one that never
/// moves is seen, of several such surfaces the last one.
class GeometryPainter {
 public:
  /// @param draw_list  has to outlive this painter
  GeometryPainter(const GlFunctions& gl, const DrawList& draw_list);

  /// The planes that buffers need for the draw list's items.
  [[nodiscard]] const GeometryPlanes& planes() const { return planes_; }

  /// Draws the selected items that are opaque.
  /// @param stand_still  whether to draw those that never move, which have to be drawn first, or
  ///   the others
  /// @param bits  which the items set in the stencil, hidden or not
  /// @param pixels  the pixels to draw; all others remain unchanged
  void paint(const View& view, const std::vector<Pose>& X_WL, const LinkSelection& drawn,
             bool stand_still, const SilhouetteBits& bits, const cv::Rect& pixels);

 private:
  void setStencil(GLuint bits);

  const GlFunctions& gl_;
  const DrawList& draw_list_;
  GeometryPlanes planes_;
  ShaderFamily programs_;
};

}  // namespace synthetic_dataset::render

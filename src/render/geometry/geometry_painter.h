#pragma once

#include "render/geometry/geometry_images.h"
#include "render/geometry/silhouette_bits.h"
#include "render/parts/draw_list.h"
#include "render/parts/shader_family.h"
#include "render/view.h"

namespace synthetic_dataset::render {

/// Draws surfaces, unlit, into the bound geometry buffer. Of surfaces at the same place that stands
/// which never moves, of several of them the last one.
class GeometryPainter {
 public:
  /// @param draw_list  has to outlive this
  GeometryPainter(const GlFunctions& gl, const DrawList& draw_list);

  /// What the buffers have to hold for these items.
  [[nodiscard]] const GeometryPlanes& planes() const { return planes_; }

  /// The selected items that one cannot see through.
  /// @param stand_still  those that do, which have to be drawn before the others, or the others
  /// @param bits  that the items set in the stencil, hidden or not
  /// @param pixels  all others stay as they are
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

#include "render/geometry/geometry_painter.h"

#include <algorithm>

#include "render/parts/item_groups.h"
#include "render/parts/surface_drawing.h"
#include "render/shaders.h"

namespace synthetic_dataset::render {
namespace {

constexpr SurfaceFeatures kUnderstood =
    feature::kTextured | feature::kHoles | feature::kTinted | feature::kNormalMap |
    feature::kRoughnessMap | feature::kMetalnessMap | feature::kEmissiveMap | feature::kNearLimit;

/// Whether there are back faces that are lit by normals which do not point towards the camera.
bool hasBacks(const DrawList& draw_list) {
  return draw_list.isClassic() &&
         std::any_of(draw_list.items().begin(), draw_list.items().end(),
                     [](const DrawItem& item) { return item.double_sided; });
}

}  // namespace

GeometryPainter::GeometryPainter(const GlFunctions& gl, const DrawList& draw_list)
    : gl_(gl),
      draw_list_(draw_list),
      planes_{(draw_list.features() & feature::kNormalMap) != 0 || hasBacks(draw_list),
              (draw_list.features() & feature::kEmissiveMap) != 0},
      programs_(gl, shaders::kMeshVertex, shaders::kGeometryFragment, kUnderstood,
                draw_list.isClassic() ? "#define CLASSIC\n" : "") {}

void GeometryPainter::paint(const View& view, const std::vector<Pose>& X_WL,
                            const LinkSelection& drawn, bool stand_still,
                            const SilhouetteBits& bits, const cv::Rect& pixels) {
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Scissor(pixels.x, pixels.y, pixels.width, pixels.height);
  gl_.DepthFunc(stand_still ? GL_GEQUAL : GL_GREATER);
  constexpr GLuint kAllBits = 0xFF;
  gl_.StencilFunc(GL_ALWAYS, kAllBits, kAllBits);
  gl_.StencilOp(GL_KEEP, GL_REPLACE, GL_REPLACE);
  const Pose X_CW = view.X_WC.inverse();
  for (const DrawItem* item : draw_list_.solidItems(X_CW, X_WL, drawn, stand_still)) {
    const Pose& X_WP = X_WL[item->link];
    if ((regionOf(*item, view, X_WP) & pixels).empty()) continue;
    const ShaderProgram& program = programs_.get(item->features | featuresOf(view));
    program.set("item", draw_list_.numberOf(*item));
    setMaterial(gl_, program, *item, draw_list_.simulator());
    setStencil(bits.of(*item));
    drawSurface(gl_, program, *item, view, X_WP);
  }
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Disable(GL_STENCIL_TEST);
  gl_.StencilMask(kAllBits);
}

/// Sets the stencil bits that drawing sets from now on; 0 for none.
void GeometryPainter::setStencil(GLuint bits) {
  if (bits == 0) {
    gl_.Disable(GL_STENCIL_TEST);
    return;
  }
  gl_.Enable(GL_STENCIL_TEST);
  gl_.StencilMask(bits);
}

}  // namespace synthetic_dataset::render

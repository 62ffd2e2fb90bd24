#include "render/geometry/geometry_painter.h"

#include <algorithm>

#include "render/parts/material_setup.h"
#include "render/parts/part_groups.h"
#include "render/parts/surface_drawing.h"
#include "render/shaders.h"

namespace synthetic_dataset::render {
namespace {

constexpr SurfaceFeatures kUnderstood =
    feature::kTextured | feature::kHoles | feature::kTinted | feature::kNormalMap |
    feature::kRoughnessMap | feature::kMetalnessMap | feature::kEmissiveMap | feature::kNearLimit;

/// Whether there are backs that are lit by other normals than those towards the camera.
bool hasBacks(const DrawList& parts) {
  return parts.isClassic() && std::any_of(parts.parts().begin(), parts.parts().end(),
                                          [](const Part& part) { return part.double_sided; });
}

}  // namespace

GeometryPainter::GeometryPainter(const GlFunctions& gl, const DrawList& parts)
    : gl_(gl),
      parts_(parts),
      planes_{(parts.features() & feature::kNormalMap) != 0 || hasBacks(parts),
              (parts.features() & feature::kEmissiveMap) != 0},
      programs_(gl, shaders::kMeshVertex, shaders::kGeometryFragment, kUnderstood,
                parts.isClassic() ? "#define CLASSIC\n" : "") {}

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
  for (const Part* part : parts_.solidParts(X_CW, X_WL, drawn, stand_still)) {
    const Pose& X_WP = X_WL[part->link];
    if ((regionOf(*part, view, X_WP) & pixels).empty()) continue;
    const ShaderProgram& program = programs_.get(part->features | featuresOf(view));
    program.set("part", parts_.numberOf(*part));
    setMaterial(gl_, program, *part, parts_.simulator());
    setStencil(bits.of(*part));
    drawSurface(gl_, program, *part, view, X_WP);
  }
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Disable(GL_STENCIL_TEST);
  gl_.StencilMask(kAllBits);
}

/// Whether and which bits what is drawn from now on sets.
void GeometryPainter::setStencil(GLuint bits) {
  if (bits == 0) {
    gl_.Disable(GL_STENCIL_TEST);
    return;
  }
  gl_.Enable(GL_STENCIL_TEST);
  gl_.StencilMask(bits);
}

}  // namespace synthetic_dataset::render

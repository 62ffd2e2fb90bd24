#include "render/shadow_painter.h"

#include "render/part_groups.h"
#include "render/shaders.h"
#include "render/surface_drawing.h"

namespace synthetic_dataset::render {

ShadowPainter::ShadowPainter(const GlFunctions& gl, const DrawList& parts, int size, int layers)
    : gl_(gl),
      parts_(parts),
      programs_(gl, shaders::kShadowVertex, shaders::kShadowFragment, feature::kHoles),
      maps_(gl, size, layers),
      layers_(static_cast<std::size_t>(layers)) {}

void ShadowPainter::begin() {
  gl_.Enable(GL_DEPTH_CLAMP);  // what stands before the map's range still casts
  gl_.DepthFunc(GL_LESS);
  gl_.Disable(GL_CULL_FACE);
}

void ShadowPainter::paint(const std::vector<ShadowProjection>& shadows,
                          const std::vector<Pose>& X_WL, const LinkSelection& casting) {
  begin();
  for (const ShadowProjection& shadow : shadows) paintLayer(shadow, X_WL, casting);
  gl_.Disable(GL_DEPTH_CLAMP);
}

void ShadowPainter::paintStanding(const std::vector<ShadowProjection>& shadows,
                                  const std::vector<Pose>& X_WL, const LinkSelection& casting) {
  begin();
  for (const ShadowProjection& shadow : shadows) paintStandingLayer(shadow, X_WL, casting);
  gl_.Disable(GL_DEPTH_CLAMP);
}

void ShadowPainter::paintStandingLayer(const ShadowProjection& shadow,
                                       const std::vector<Pose>& X_WL,
                                       const LinkSelection& casting) {
  Layer& layer = layers_[static_cast<std::size_t>(shadow.layer)];
  if (isSame(layer, shadow, casting) && layer.is_kept) {
    maps_.beginKept(shadow.layer, layer.changed);
  } else {
    maps_.begin(shadow.layer);
    draw(shadow, X_WL, casting, Casters::kStanding);
    maps_.keep(shadow.layer);
    layer = {shadow.shadow_from_world, casting, true, {}};
  }
  layer.changed.clear();
}

void ShadowPainter::paintLayer(const ShadowProjection& shadow, const std::vector<Pose>& X_WL,
                               const LinkSelection& casting) {
  Layer& layer = layers_[static_cast<std::size_t>(shadow.layer)];
  if (!isSame(layer, shadow, casting)) {
    // It may not come again: a copy would be made for nothing.
    layer = {shadow.shadow_from_world, casting, false, {}};
    maps_.begin(shadow.layer);
    draw(shadow, X_WL, casting, Casters::kAll);
    return;
  }
  paintStandingLayer(shadow, X_WL, casting);
  draw(shadow, X_WL, casting, Casters::kMoving);
  layer.changed = texelsOfMoving(shadow, X_WL, casting);
}

bool ShadowPainter::isSame(const Layer& layer, const ShadowProjection& shadow,
                           const LinkSelection& casting) {
  return layer.shadow_from_world == shadow.shadow_from_world && layer.casting == casting;
}

/// Those within the bounds of moving casters, and a few more.
std::vector<Eigen::AlignedBox2i> ShadowPainter::texelsOfMoving(const ShadowProjection& shadow,
                                                               const std::vector<Pose>& X_WL,
                                                               const LinkSelection& casting) const {
  std::vector<Eigen::AlignedBox2i> all;
  const auto casters = boundsOfGroups(parts_.parts(), X_WL, [&](const Part& part) {
    return part.casts_shadow && casting[part.link] && !part.stands_still;
  });
  for (const Bounds& caster : casters) {
    const Eigen::AlignedBox2i texels = texelsOf(caster, shadow);
    if (!texels.isEmpty()) all.push_back(texels);
  }
  return all;
}

Eigen::AlignedBox2i ShadowPainter::texelsOf(const Bounds& caster,
                                            const ShadowProjection& shadow) const {
  constexpr int kSlack = 2;  // [texel]
  const Eigen::AlignedBox2i whole = maps_.whole();
  const double size = whole.sizes().x() + 1;
  Eigen::AlignedBox2d texels;
  for (const Eigen::Vector3d& corner : cornersOf(caster)) {
    const Eigen::Vector4d clip = shadow.shadow_from_world * corner.homogeneous();
    if (clip.w() < 1e-6) return whole;  // behind the lamp, where corners bound nothing
    texels.extend(Eigen::Vector2d(((clip.head<2>() / clip.w()).array() * 0.5 + 0.5) * size));
  }
  const Eigen::Vector2d low = texels.min().cwiseMax(0.0).cwiseMin(size);
  const Eigen::Vector2d high = texels.max().cwiseMax(0.0).cwiseMin(size);
  const Eigen::AlignedBox2i result(Eigen::Vector2i(low.array().floor().cast<int>() - kSlack),
                                   Eigen::Vector2i(high.array().ceil().cast<int>() + kSlack));
  return result.intersection(whole);
}

void ShadowPainter::draw(const ShadowProjection& shadow, const std::vector<Pose>& X_WL,
                         const LinkSelection& casting, Casters casters) {
  for (const Part& part : parts_.parts()) {
    if (!part.casts_shadow || !casting[part.link]) continue;
    if (casters != Casters::kAll && part.stands_still != (casters == Casters::kStanding)) continue;
    const Eigen::Matrix4d shadow_from_mesh =
        shadow.shadow_from_world * (X_WL[part.link] * part.X_LV).matrix();
    const ShaderProgram& program = programs_.get(part.features);
    program.use();
    program.set("shadow_from_mesh", Eigen::Matrix4f(shadow_from_mesh.cast<float>()));
    bindHoles(gl_, program, part);
    part.mesh->draw();
  }
}

}  // namespace synthetic_dataset::render

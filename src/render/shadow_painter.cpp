#include "render/shadow_painter.h"

#include <opencv2/imgproc.hpp>

#include "render/part_groups.h"
#include "render/shaders.h"
#include "render/surface_drawing.h"

namespace synthetic_dataset::render {
namespace {

/// The texels of a box, of which the last ones are inside.
cv::Rect rectangleOf(const Eigen::AlignedBox2i& box) {
  const Eigen::Vector2i size = box.sizes() + Eigen::Vector2i(1, 1);
  return {box.min().x(), box.min().y(), size.x(), size.y()};
}

cv::Rect grown(const cv::Rect& rectangle, int by) {
  return {rectangle.x - by, rectangle.y - by, rectangle.width + 2 * by, rectangle.height + 2 * by};
}

}  // namespace

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

ChangedTexels ShadowPainter::changedTexels(const ShadowProjection& shadow,
                                           const std::vector<Pose>& X_WL,
                                           const LinkSelection& casting) const {
  // Surfaces are compared up to 2.8 texels above themselves, with two texels on each side; and one
  // to spare. (lighting.glsl)
  constexpr int kReach = 6;
  const Layer& layer = layers_[static_cast<std::size_t>(shadow.layer)];
  const cv::Rect whole = rectangleOf(maps_.whole());
  const double half = 0.5 * whole.width;
  ChangedTexels changed;
  Eigen::Matrix4d texels_from_shadow = Eigen::Matrix4d::Identity();
  texels_from_shadow.row(0) = Eigen::Vector4d(half, 0.0, 0.0, half);
  texels_from_shadow.row(1) = Eigen::Vector4d(0.0, half, 0.0, half);
  changed.texels_from_world = texels_from_shadow * shadow.shadow_from_world;
  std::vector<cv::Rect> boxes;
  for (const Eigen::AlignedBox2i& box : texelsOfMoving(shadow, X_WL, casting)) {
    boxes.push_back(grown(rectangleOf(box), kReach) & whole);
    changed.place |= boxes.back();
  }
  changed.texels = cv::Mat::zeros(changed.place.size(), CV_8UC1);
  for (const cv::Rect& box : boxes) {
    cv::Mat differing(box.size(), CV_8UC1, cv::Scalar(255));
    if (layer.is_kept) differing = maps_.differing(shadow.layer, box);
    const cv::Size reach(2 * kReach + 1, 2 * kReach + 1);
    cv::dilate(differing, differing, cv::getStructuringElement(cv::MORPH_RECT, reach));
    cv::Mat target = changed.texels(box - changed.place.tl());
    target |= differing;
  }
  return changed;
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

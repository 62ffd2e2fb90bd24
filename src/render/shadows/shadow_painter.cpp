#include "render/shadows/shadow_painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include <opencv2/core.hpp>

#include "render/parts/item_groups.h"
#include "render/parts/surface_drawing.h"
#include "render/shaders.h"

namespace synthetic_dataset::render {
namespace {

cv::Rect widenedBy(const cv::Rect& rectangle, const cv::Size& by) {
  return {rectangle.x - by.width, rectangle.y - by.height, rectangle.width + 2 * by.width,
          rectangle.height + 2 * by.height};
}

/// Whether the light is parallel (directional).
bool isParallel(const ShadowProjection& shadow) {
  return shadow.shadow_from_world.row(3).head<3>().isZero();
}

/// Where an item is with respect to a map's light: all of it in front of the light's plane, none of
/// it in the map, or neither.
enum class InLight { kBefore, kNot, kPartly };

InLight placeOf(const DrawItem& item, const Pose& X_WL, const ShadowProjection& shadow) {
  constexpr double kNearest = 1e-3;  // [m]
  const Eigen::Matrix4d map_from_item = shadow.shadow_from_world * (X_WL * item.X_LV).matrix();
  bool is_before = true;
  std::array<bool, 5> is_beyond = {true, true, true, true, true};  // the light's plane, four sides
  for (const Eigen::Vector3d& corner : cornersOf(item.bounds_V)) {
    const Eigen::Vector4d at = map_from_item * corner.homogeneous();
    is_before = is_before && at.w() > kNearest;
    const std::array<bool, 5> beyond = {at.w() < 0.0, at.x() < -at.w(), at.x() > at.w(),
                                        at.y() < -at.w(), at.y() > at.w()};
    std::transform(beyond.begin(), beyond.end(), is_beyond.begin(), is_beyond.begin(),
                   std::logical_and<>());
  }
  if (is_before) return InLight::kBefore;
  const bool is_out = std::find(is_beyond.begin(), is_beyond.end(), true) != is_beyond.end();
  return is_out ? InLight::kNot : InLight::kPartly;
}

/// Whether triangles that face away from the light cast no shadow. A point light therefore shines
/// out of a closed body around it, such as its bulb; a spot light does not, as in OGRE.
bool castsByFront(const DrawItem& item, const ShadowProjection& shadow) {
  return item.casts_by_front && (isParallel(shadow) || shadow.is_side);
}

/// The matrix that transforms a map's clip coordinates to its columns and rows.
Eigen::Matrix4d texelsFromShadow(int size) {
  const double half = 0.5 * size;
  Eigen::Matrix4d texels_from_shadow = Eigen::Matrix4d::Identity();
  texels_from_shadow.row(0) = Eigen::Vector4d(half, 0.0, 0.0, half);
  texels_from_shadow.row(1) = Eigen::Vector4d(0.0, half, 0.0, half);
  return texels_from_shadow;
}

/// @param map_from_world  to columns, rows and depths
CastBody bodyOf(const DrawItem& item, const Pose& X_WL, const ShadowProjection& shadow,
                const Eigen::Matrix4d& map_from_world) {
  const Eigen::Matrix4d map_from_mesh = map_from_world * (X_WL * item.X_LV).matrix();
  return {item.shape, Eigen::Projective3f(map_from_mesh.cast<float>()), castsByFront(item, shadow)};
}

/// How many columns and rows from its own place a surface's light lookup reaches.
cv::Size reachOf(const ShadowProjection& shadow, int map_size) {
  constexpr int kGathered = 2;  // on each side (lighting.glsl)
  constexpr int kSpare = 1;
  constexpr double kRaise = kShadowRaise + kGrazingShadowRaise;
  const double softness = std::min(shadow.softness.maxCoeff(), kWidestSoftness);
  const double half = 0.5 * map_size;
  const auto reach = [&](double shift) {
    const int gathered =
        softness > 0.0 ? static_cast<int>(std::ceil(softness)) + MapDepths::kCell : 0;
    return static_cast<int>(std::ceil(shift)) + std::max(gathered, kGathered) + kSpare;
  };
  const Eigen::Matrix4d& map = shadow.shadow_from_world;
  if (isParallel(shadow)) {
    const auto texels_in_metre = [&](int axis) { return half * map.row(axis).head<3>().norm(); };
    return {reach(kRaise * shadow.texel * texels_in_metre(0)),
            reach(kRaise * shadow.texel * texels_in_metre(1))};
  }
  // In the plane of a light's map, a sideways shift is magnified by the square of the ray's slant.
  const double tangent = half * shadow.texel;
  const int shift = reach(kRaise * (1.0 + tangent * tangent));
  return {shift, shift};
}

/// The texels around a caster's shadow, with a small margin.
/// @param whole  all texels of the map
cv::Rect texelsOf(const std::vector<Eigen::Vector3d>& caster, const ShadowProjection& shadow,
                  const cv::Rect& whole) {
  constexpr int kSlack = 3;  // [texel]
  const double size = whole.width;
  Eigen::AlignedBox2d texels;
  for (const Eigen::Vector3d& corner : caster) {
    const Eigen::Vector4d clip = shadow.shadow_from_world * corner.homogeneous();
    if (clip.w() < 1e-6) return whole;  // behind the light, where corners bound nothing
    texels.extend(Eigen::Vector2d(((clip.head<2>() / clip.w()).array() * 0.5 + 0.5) * size));
  }
  const Eigen::Vector2i low = texels.min().cwiseMax(0.0).cwiseMin(size).array().floor().cast<int>();
  const Eigen::Vector2i high = texels.max().cwiseMax(0.0).cwiseMin(size).array().ceil().cast<int>();
  const cv::Rect exact(cv::Point(low.x(), low.y()), cv::Point(high.x(), high.y()));
  return widenedBy(exact, {kSlack, kSlack}) & whole;
}

}  // namespace

ShadowPainter::ShadowPainter(const GlFunctions& gl, const DrawList& draw_list,
                             const ShadowLayout& layout)
    : gl_(gl),
      draw_list_(draw_list),
      programs_(gl, shaders::kShadowVertex, shaders::kShadowFragment, feature::kHoles),
      maps_(gl, layout.map_size, layout.maps),
      sides_(gl, layout.side_size, layout.sides),
      has_glass_(std::any_of(draw_list.items().begin(), draw_list.items().end(),
                             [](const DrawItem& item) { return item.transparent; })) {
  for (int map = 0; map < layout.maps; ++map) layers_.push_back({&maps_, map, {maps_.whole()}});
  for (int side = 0; side < layout.sides; ++side)
    layers_.push_back({&sides_, side, {sides_.whole()}});
}

void ShadowPainter::begin() {
  gl_.Enable(GL_DEPTH_CLAMP);  // what is in front of the map's range still casts shadows
  gl_.DepthFunc(GL_LESS);
}

void ShadowPainter::paint(const std::vector<ShadowProjection>& shadows,
                          const std::vector<Pose>& X_WL, const LinkSelection& casting,
                          const std::vector<LinkSelection>& moving, const CasterPoses* casters) {
  begin();
  for (std::size_t i = 0; i < shadows.size(); ++i) {
    paintLayer(shadows[i], casters != nullptr ? (*casters)[i] : X_WL, casting,
               moving.empty() ? casting : moving[i]);
  }
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
  Layer& layer = layerOf(shadow);
  if (layer.isSame(shadow, casting) && layer.is_kept) {
    layer.standing->keep();
    layer.moving.clear();
    if (has_glass_) layer.maps->beginKept(layer.number, std::exchange(layer.overdrawn, {}));
    return;
  }
  layer.begin(shadow, casting);
  layer.is_kept = true;
  if (isCastByRaster(shadow, X_WL, casting, true)) {
    layer.standing = std::make_shared<MapDepths::Standing>(castStanding(shadow, X_WL, casting));
    return;
  }
  layer.maps->begin(layer.number);
  draw(shadow, X_WL, casting, Casters::kStanding);
  layer.standing = layer.readAll();
  layer.overdrawn = {layer.maps->whole()};
  if (has_glass_) {
    layer.maps->keep(layer.number);
    layer.overdrawn.clear();
  }
}

/// @param moving  the links that cast shadows among those that move
void ShadowPainter::paintLayer(const ShadowProjection& shadow, const std::vector<Pose>& X_WL,
                               const LinkSelection& casting, const LinkSelection& moving) {
  Layer& layer = layerOf(shadow);
  if (has_glass_ && !layer.isSame(shadow, casting)) {
    // The projection may not recur: a copy would be wasted.
    layer.begin(shadow, casting);
    layer.maps->begin(layer.number);
    draw(shadow, X_WL, casting, Casters::kAll);
    layer.standing = layer.readAll();
    return;
  }
  paintStandingLayer(shadow, X_WL, casting);
  if (isCastByRaster(shadow, X_WL, casting, false)) {
    layer.moving = castPieces(shadow, X_WL, moving);
    return;
  }
  if (!has_glass_) layer.maps->beginAgain(layer.number, layer.overdrawn);
  draw(shadow, X_WL, moving, Casters::kMoving);
  layer.overdrawn = texelsOfMoving(shadow, X_WL, moving);
  for (const cv::Rect& texels : layer.overdrawn) {
    layer.moving.push_back({texels, layer.maps->read(layer.number, texels)});
  }
}

/// Whether what never moves, or what does, can be drawn without OpenGL.
bool ShadowPainter::isCastByRaster(const ShadowProjection& shadow, const std::vector<Pose>& X_WL,
                                   const LinkSelection& casting, bool stand_still) const {
  const std::vector<DrawItem>& items = draw_list_.items();
  return !has_glass_ && std::none_of(items.begin(), items.end(), [&](const DrawItem& item) {
    if (!item.casts_shadow || item.stands_still != stand_still || !casting[item.link]) return false;
    return item.has_holes || placeOf(item, X_WL[item.link], shadow) == InLight::kPartly;
  });
}

/// The depths of what never moves: CV_32FC1.
cv::Mat ShadowPainter::castStanding(const ShadowProjection& shadow, const std::vector<Pose>& X_WL,
                                    const LinkSelection& casting) const {
  const int size = layers_[static_cast<std::size_t>(shadow.map)].size();
  const Eigen::Matrix4d map_from_world = texelsFromShadow(size) * shadow.shadow_from_world;
  std::vector<CastBody> bodies;
  for (const DrawItem& item : draw_list_.items()) {
    if (!item.casts_shadow || !casting[item.link] || !item.stands_still) continue;
    if (placeOf(item, X_WL[item.link], shadow) == InLight::kNot) continue;
    bodies.push_back(bodyOf(item, X_WL[item.link], shadow, map_from_world));
  }
  return castMap(bodies, size);
}

std::vector<MapPiece> ShadowPainter::castPieces(const ShadowProjection& shadow,
                                                const std::vector<Pose>& X_WL,
                                                const LinkSelection& casting) {
  const int size = layerOf(shadow).size();
  const Eigen::Matrix4d map_from_world = texelsFromShadow(size) * shadow.shadow_from_world;
  std::vector<Cast*> casts;
  std::vector<Cast*> changed;
  for (const DrawItem& item : draw_list_.items()) {
    if (!item.casts_shadow || !casting[item.link] || item.stands_still) continue;
    if (placeOf(item, X_WL[item.link], shadow) == InLight::kNot) continue;
    const CastBody body = bodyOf(item, X_WL[item.link], shadow, map_from_world);
    const auto [known, is_new] = casts_.try_emplace({shadow.map, &item});
    Cast& cast = known->second;
    if (is_new || !cast.isOf(body)) {
      cast = {body, std::nullopt};
      changed.push_back(&cast);
    }
    casts.push_back(&cast);
  }
  cv::parallel_for_(cv::Range(0, static_cast<int>(changed.size())), [&](const cv::Range& some) {
    for (int i = some.start; i < some.end; ++i) {
      Cast& cast = *changed[static_cast<std::size_t>(i)];
      cast.piece = castPiece(cast.body, size);
    }
  });
  std::vector<MapPiece> pieces;
  for (const Cast* cast : casts) {
    if (cast->piece) pieces.push_back(*cast->piece);
  }
  return pieces;
}

MapDepths ShadowPainter::depths(const ShadowProjection& shadow) const {
  const Layer& layer = layerOf(shadow);
  return MapDepths(layer.standing, layer.moving);
}

std::vector<ChangedTexels> ShadowPainter::changedTexels(
    const std::vector<ShadowProjection>& shadows) const {
  std::vector<ChangedTexels> changed;
  for (const ShadowProjection& shadow : shadows) changed.push_back(changedIn(shadow));
  return changed;
}

ChangedTexels ShadowPainter::changedIn(const ShadowProjection& shadow) const {
  const Layer& layer = layerOf(shadow);
  const int size = layer.size();
  const Eigen::Matrix4d texels_from_world = texelsFromShadow(size) * shadow.shadow_from_world;
  const cv::Size reach = reachOf(shadow, size);
  return layer.is_kept ? changedBy(layer.moving, layer.standing->depths(), reach, texels_from_world)
                       : allChanged(layer.maps->whole(), reach, texels_from_world);
}

/// Resets the layer for a new projection; nothing is drawn yet.
void ShadowPainter::Layer::begin(const ShadowProjection& shadow, const LinkSelection& casters) {
  *this = {maps, number, std::move(overdrawn), shadow.shadow_from_world, casters};
}

bool ShadowPainter::Layer::isSame(const ShadowProjection& shadow,
                                  const LinkSelection& casters) const {
  return shadow_from_world == shadow.shadow_from_world && casting == casters;
}

std::shared_ptr<MapDepths::Standing> ShadowPainter::Layer::readAll() const {
  return std::make_shared<MapDepths::Standing>(maps->read(number, maps->whole()));
}

/// The texels within the bounds of moving casters, with a small margin.
std::vector<cv::Rect> ShadowPainter::texelsOfMoving(const ShadowProjection& shadow,
                                                    const std::vector<Pose>& X_WL,
                                                    const LinkSelection& casting) const {
  std::vector<cv::Rect> all;
  const auto casters = hullsOfGroups(draw_list_.items(), X_WL, 0.0, [&](const DrawItem& item) {
    return item.casts_shadow && casting[item.link] && !item.stands_still;
  });
  for (const std::vector<Eigen::Vector3d>& caster : casters) {
    const cv::Rect texels = texelsOf(caster, shadow, layerOf(shadow).maps->whole());
    if (!texels.empty()) all.push_back(texels);
  }
  return all;
}

void ShadowPainter::draw(const ShadowProjection& shadow, const std::vector<Pose>& X_WL,
                         const LinkSelection& casting, Casters casters) {
  for (const DrawItem& item : draw_list_.items()) {
    if (!item.casts_shadow || !casting[item.link]) continue;
    if (casters != Casters::kAll && item.stands_still != (casters == Casters::kStanding)) continue;
    const Eigen::Matrix4d shadow_from_mesh =
        shadow.shadow_from_world * (X_WL[item.link] * item.X_LV).matrix();
    const ShaderProgram& program = programs_.get(item.features);
    program.use();
    program.set("shadow_from_mesh", Eigen::Matrix4f(shadow_from_mesh.cast<float>()));
    bindHoles(gl_, program, item);
    if (castsByFront(item, shadow)) {
      gl_.Enable(GL_CULL_FACE);
    } else {
      gl_.Disable(GL_CULL_FACE);
    }
    item.mesh->draw();
  }
}

}  // namespace synthetic_dataset::render

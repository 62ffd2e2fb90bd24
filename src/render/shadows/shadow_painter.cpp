#include "render/shadows/shadow_painter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "render/parts/part_groups.h"
#include "render/parts/surface_drawing.h"
#include "render/shaders.h"
#include "render/shadows/shadow_raster.h"

namespace synthetic_dataset::render {
namespace {

cv::Rect grown(const cv::Rect& rectangle, const cv::Size& by) {
  return {rectangle.x - by.width, rectangle.y - by.height, rectangle.width + 2 * by.width,
          rectangle.height + 2 * by.height};
}

/// Whether the light comes from far away.
bool isParallel(const ShadowProjection& shadow) {
  return shadow.shadow_from_world.row(3).head<3>().isZero();
}

/// On which side of a light's plane a part is, before which it shines.
enum class LightSide { kBefore, kBehind, kBoth };

LightSide sideOf(const Part& part, const Pose& X_WL, const ShadowProjection& shadow) {
  constexpr double kNearest = 1e-3;  // [m]
  const Eigen::RowVector4d distance = shadow.shadow_from_world.row(3) * (X_WL * part.X_LV).matrix();
  bool is_before = true;
  bool is_behind = true;
  for (const Eigen::Vector3d& corner : cornersOf(part.bounds_V)) {
    const double along = distance.dot(corner.homogeneous());
    is_before = is_before && along > kNearest;
    is_behind = is_behind && along < 0.0;
  }
  return is_before ? LightSide::kBefore : is_behind ? LightSide::kBehind : LightSide::kBoth;
}

/// Columns and rows of a map from its clip coordinates.
Eigen::Matrix4d texelsFromShadow(int size) {
  const double half = 0.5 * size;
  Eigen::Matrix4d texels_from_shadow = Eigen::Matrix4d::Identity();
  texels_from_shadow.row(0) = Eigen::Vector4d(half, 0.0, 0.0, half);
  texels_from_shadow.row(1) = Eigen::Vector4d(0.0, half, 0.0, half);
  return texels_from_shadow;
}

/// How many columns and rows from its own place a surface's light asks for texels.
cv::Size reachOf(const ShadowProjection& shadow, int map_size) {
  constexpr int kGathered = 2;  // on each side (lighting.glsl)
  constexpr int kSpare = 1;
  constexpr double kRaise = kShadowRaise + kGrazingShadowRaise;
  const double half = 0.5 * map_size;
  const auto reach = [](double shift) {
    return static_cast<int>(std::ceil(shift)) + kGathered + kSpare;
  };
  const Eigen::Matrix4d& map = shadow.shadow_from_world;
  if (isParallel(shadow)) {
    const auto texels_in_metre = [&](int axis) { return half * map.row(axis).head<3>().norm(); };
    return {reach(kRaise * shadow.texel * texels_in_metre(0)),
            reach(kRaise * shadow.texel * texels_in_metre(1))};
  }
  // In a light's plane of tangents, what is moved aside moves by the square of its ray's slant.
  const double tangent = half * shadow.texel;
  const int shift = reach(kRaise * (1.0 + tangent * tangent));
  return {shift, shift};
}

constexpr int kCell = ChangedTexels::kCell;

int cellOf(int texel) {
  return texel >= 0 ? texel / kCell : -((kCell - 1 - texel) / kCell);  // towards the negative
}

/// The cells of some texels.
cv::Rect cellsOf(const cv::Rect& texels) {
  return {
      cv::Point(cellOf(texels.x), cellOf(texels.y)),
      cv::Point(cellOf(texels.x + texels.width - 1) + 1, cellOf(texels.y + texels.height - 1) + 1)};
}

/// Marks the cells of texels that are not 0.
/// @param texels  CV_8UC1
/// @param first  where these are in the map
/// @param place  of the cells
void markCells(const cv::Mat& texels, const cv::Point& first, const cv::Rect& place,
               cv::Mat& cells) {
  for (int row = 0; row < texels.rows; ++row) {
    const auto* is_set = texels.ptr<unsigned char>(row);
    auto* marked = cells.ptr<unsigned char>(cellOf(first.y + row) - place.y);
    for (int column = 0; column < texels.cols; ++column) {
      if (is_set[column] != 0) marked[cellOf(first.x + column) - place.x] = 255;
    }
  }
}

/// Grown on all sides; where that is far, all of it, which takes less time.
void grow(cv::Mat& cells, const cv::Size& by) {
  constexpr int kFar = 16;
  if (std::max(by.width, by.height) > kFar) {
    cells.setTo(255);
    return;
  }
  const cv::Size round(2 * by.width + 1, 2 * by.height + 1);
  cv::dilate(cells, cells, cv::getStructuringElement(cv::MORPH_RECT, round));
}

}  // namespace

ShadowPainter::ShadowPainter(const GlFunctions& gl, const DrawList& parts, int size, int layers)
    : gl_(gl),
      parts_(parts),
      programs_(gl, shaders::kShadowVertex, shaders::kShadowFragment, feature::kHoles),
      maps_(gl, size, layers),
      has_glass_(std::any_of(parts.parts().begin(), parts.parts().end(),
                             [](const Part& part) { return part.transparent; })),
      layers_(static_cast<std::size_t>(layers)) {}

void ShadowPainter::begin() {
  gl_.Enable(GL_DEPTH_CLAMP);  // what stands before the map's range still casts
  gl_.DepthFunc(GL_LESS);
}

void ShadowPainter::paint(const std::vector<ShadowProjection>& shadows,
                          const std::vector<Pose>& X_WL, const LinkSelection& casting,
                          const std::vector<LinkSelection>& moving) {
  begin();
  for (std::size_t i = 0; i < shadows.size(); ++i) {
    paintLayer(shadows[i], X_WL, casting, moving.empty() ? casting : moving[i]);
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
  Layer& layer = layers_[static_cast<std::size_t>(shadow.layer)];
  if (isSame(layer, shadow, casting) && layer.is_kept) {
    maps_.beginKept(shadow.layer, layer.overdrawn);
    layer.overdrawn.clear();
    layer.moving.clear();
  } else {
    maps_.begin(shadow.layer);
    draw(shadow, X_WL, casting, Casters::kStanding);
    // In a light with a place, things may move to where OpenGL has to draw them.
    const bool is_needed = !isParallel(shadow) || !isCastByRaster(shadow, X_WL, casting);
    if (is_needed) maps_.keep(shadow.layer);
    layer = {shadow.shadow_from_world, casting, true, {}, {}, readAll(shadow.layer)};
  }
}

/// @param moving  the links that cast among those that move
void ShadowPainter::paintLayer(const ShadowProjection& shadow, const std::vector<Pose>& X_WL,
                               const LinkSelection& casting, const LinkSelection& moving) {
  Layer& layer = layers_[static_cast<std::size_t>(shadow.layer)];
  if (isCastByRaster(shadow, X_WL, casting)) {
    paintStandingLayer(shadow, X_WL, casting);
    layer.moving = castPieces(shadow, X_WL, moving);
    return;
  }
  if (!isSame(layer, shadow, casting)) {
    // It may not come again: a copy would be made for nothing.
    maps_.begin(shadow.layer);
    draw(shadow, X_WL, casting, Casters::kAll);
    layer = {shadow.shadow_from_world, casting, false, {}, {}, readAll(shadow.layer)};
    return;
  }
  paintStandingLayer(shadow, X_WL, casting);
  draw(shadow, X_WL, moving, Casters::kMoving);
  layer.overdrawn = texelsOfMoving(shadow, X_WL, moving);
  for (const cv::Rect& texels : layer.overdrawn) {
    layer.moving.push_back({texels, maps_.read(shadow.layer, texels)});
  }
}

/// Whether what moves need not be drawn with OpenGL.
bool ShadowPainter::isCastByRaster(const ShadowProjection& shadow, const std::vector<Pose>& X_WL,
                                   const LinkSelection& casting) const {
  const std::vector<Part>& parts = parts_.parts();
  return !has_glass_ && std::none_of(parts.begin(), parts.end(), [&](const Part& part) {
    if (!part.casts_shadow || part.stands_still || !casting[part.link]) return false;
    return part.has_holes || sideOf(part, X_WL[part.link], shadow) == LightSide::kBoth;
  });
}

std::vector<MapPiece> ShadowPainter::castPieces(const ShadowProjection& shadow,
                                                const std::vector<Pose>& X_WL,
                                                const LinkSelection& casting) {
  const int size = maps_.whole().width;
  const Eigen::Matrix4d map_from_world = texelsFromShadow(size) * shadow.shadow_from_world;
  std::vector<MapPiece> pieces;
  for (const Part& part : parts_.parts()) {
    if (!part.casts_shadow || !casting[part.link] || part.stands_still) continue;
    if (sideOf(part, X_WL[part.link], shadow) == LightSide::kBehind) continue;
    const Eigen::Matrix4d map_from_mesh = map_from_world * (X_WL[part.link] * part.X_LV).matrix();
    // A light may be within a body.
    const bool fronts_alone = part.casts_by_front && isParallel(shadow);
    const auto [known, is_new] = casts_.try_emplace({shadow.layer, &part});
    Cast& cast = known->second;
    if (is_new || cast.map_from_mesh != map_from_mesh || cast.fronts_alone != fronts_alone) {
      const Eigen::Projective3f map_from_vertex(map_from_mesh.cast<float>());
      cast = {map_from_mesh, fronts_alone,
              castPiece(*part.shape, map_from_vertex, size, fronts_alone)};
    }
    if (cast.piece) pieces.push_back(*cast.piece);
  }
  return pieces;
}

std::shared_ptr<MapDepths::Standing> ShadowPainter::readAll(int layer) const {
  return std::make_shared<MapDepths::Standing>(maps_.read(layer, maps_.whole()));
}

MapDepths ShadowPainter::depths(const ShadowProjection& shadow) const {
  const Layer& layer = layers_[static_cast<std::size_t>(shadow.layer)];
  return MapDepths(layer.standing, layer.moving);
}

ChangedTexels ShadowPainter::changedTexels(const ShadowProjection& shadow) const {
  const Layer& layer = layers_[static_cast<std::size_t>(shadow.layer)];
  const int size = maps_.whole().width;
  ChangedTexels changed;
  changed.texels_from_world = texelsFromShadow(size) * shadow.shadow_from_world;
  const cv::Size reach = reachOf(shadow, size);
  const cv::Size cell_reach((reach.width + kCell - 1) / kCell, (reach.height + kCell - 1) / kCell);
  // Surfaces beside the map may be raised onto it.
  if (!layer.is_kept) {
    changed.place = grown(cellsOf(maps_.whole()), cell_reach);
    changed.cells = cv::Mat(changed.place.size(), CV_8UC1, cv::Scalar(255));
    return changed;
  }
  for (const MapPiece& piece : layer.moving) {
    changed.place |= grown(cellsOf(piece.texels), cell_reach);
  }
  changed.cells = cv::Mat::zeros(changed.place.size(), CV_8UC1);
  cv::Mat differing;
  for (const MapPiece& piece : layer.moving) {
    cv::compare(piece.depths, layer.standing->depths()(piece.texels), differing, cv::CMP_LT);
    const cv::Rect round = grown(cellsOf(piece.texels), cell_reach);
    cv::Mat cells = cv::Mat::zeros(round.size(), CV_8UC1);
    markCells(differing, piece.texels.tl(), round, cells);
    grow(cells, cell_reach);
    cv::Mat target = changed.cells(round - changed.place.tl());
    target |= cells;
  }
  return changed;
}

bool ShadowPainter::isSame(const Layer& layer, const ShadowProjection& shadow,
                           const LinkSelection& casting) {
  return layer.shadow_from_world == shadow.shadow_from_world && layer.casting == casting;
}

/// Those within the bounds of moving casters, and a few more.
std::vector<cv::Rect> ShadowPainter::texelsOfMoving(const ShadowProjection& shadow,
                                                    const std::vector<Pose>& X_WL,
                                                    const LinkSelection& casting) const {
  std::vector<cv::Rect> all;
  const auto casters = hullsOfGroups(parts_.parts(), X_WL, 0.0, [&](const Part& part) {
    return part.casts_shadow && casting[part.link] && !part.stands_still;
  });
  for (const std::vector<Eigen::Vector3d>& caster : casters) {
    const cv::Rect texels = texelsOf(caster, shadow);
    if (!texels.empty()) all.push_back(texels);
  }
  return all;
}

cv::Rect ShadowPainter::texelsOf(const std::vector<Eigen::Vector3d>& caster,
                                 const ShadowProjection& shadow) const {
  constexpr int kSlack = 3;  // [texel]
  const cv::Rect whole = maps_.whole();
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
  return grown(exact, {kSlack, kSlack}) & whole;
}

void ShadowPainter::draw(const ShadowProjection& shadow, const std::vector<Pose>& X_WL,
                         const LinkSelection& casting, Casters casters) {
  // A light may be within a body.
  const bool is_parallel = isParallel(shadow);
  for (const Part& part : parts_.parts()) {
    if (!part.casts_shadow || !casting[part.link]) continue;
    if (casters != Casters::kAll && part.stands_still != (casters == Casters::kStanding)) continue;
    const Eigen::Matrix4d shadow_from_mesh =
        shadow.shadow_from_world * (X_WL[part.link] * part.X_LV).matrix();
    const ShaderProgram& program = programs_.get(part.features);
    program.use();
    program.set("shadow_from_mesh", Eigen::Matrix4f(shadow_from_mesh.cast<float>()));
    bindHoles(gl_, program, part);
    if (part.casts_by_front && is_parallel) {
      gl_.Enable(GL_CULL_FACE);
    } else {
      gl_.Disable(GL_CULL_FACE);
    }
    part.mesh->draw();
  }
}

}  // namespace synthetic_dataset::render

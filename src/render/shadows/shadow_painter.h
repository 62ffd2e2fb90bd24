#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "render/parts/draw_list.h"
#include "render/parts/shader_family.h"
#include "render/shadows/changed_texels.h"
#include "render/shadows/held_casters.h"
#include "render/shadows/map_depths.h"
#include "render/shadows/shadow_maps.h"
#include "render/shadows/shadow_projection.h"
#include "render/shadows/shadow_raster.h"

namespace synthetic_dataset::render {

/// Draws the shadow maps.
///
/// What never moves is drawn once for all pictures that have the same projection, and what moves on
/// top of it: the least depths do not depend on the order, so the map's texels are the same.
/// Triangles are rasterized by this program on the CPU; OpenGL draws what has holes or is only
/// partly in front of a light, and everything if there is glass, whose shader looks the maps up.
class ShadowPainter {
 public:
  /// @param draw_list  has to outlive this painter
  ShadowPainter(const GlFunctions& gl, const DrawList& draw_list, const ShadowLayout& layout);

  /// @param moving  for each shadow, the links of interest among those that cast it and move; empty
  ///     for all
  /// @param casters  the poses in which links cast shadows, if they differ from X_WL
  void paint(const std::vector<ShadowProjection>& shadows, const std::vector<Pose>& X_WL,
             const LinkSelection& casting, const std::vector<LinkSelection>& moving = {},
             const CasterPoses* casters = nullptr);

  /// Draws only the shadows of what never moves.
  void paintStanding(const std::vector<ShadowProjection>& shadows, const std::vector<Pose>& X_WL,
                     const LinkSelection& casting);

  /// For each shadow, the texels that differ from those of what never moves since the last paint().
  [[nodiscard]] std::vector<ChangedTexels> changedTexels(
      const std::vector<ShadowProjection>& shadows) const;

  /// The depths that were drawn last.
  [[nodiscard]] MapDepths depths(const ShadowProjection& shadow) const;

  /// The maps as textures for OpenGL, up to date only if there is glass: all maps that are not
  /// sides of cubes, and all sides.
  [[nodiscard]] GLuint maps() const { return maps_.texture(); }
  [[nodiscard]] GLuint sides() const { return sides_.texture(); }

 private:
  enum class Casters { kAll, kStanding, kMoving };

  /// A map, and what it was drawn with last.
  struct Layer {
    ShadowMaps* maps;                 ///< the maps that contain it
    int number;                       ///< its number among these
    std::vector<cv::Rect> overdrawn;  ///< texels where OpenGL drew more than what is kept

    Eigen::Matrix4d shadow_from_world = Eigen::Matrix4d::Zero();
    LinkSelection casting = {};
    bool is_kept = false;               ///< whether standing casters are kept separately
    std::vector<MapPiece> moving = {};  ///< what moves, drawn on top of standing casters
    std::shared_ptr<MapDepths::Standing> standing = nullptr;  ///< or all, if not is_kept

    void begin(const ShadowProjection& shadow, const LinkSelection& casters);
    [[nodiscard]] bool isSame(const ShadowProjection& shadow, const LinkSelection& casters) const;
    [[nodiscard]] int size() const { return maps->whole().width; }
    [[nodiscard]] std::shared_ptr<MapDepths::Standing> readAll() const;
  };

  /// How an item last cast its shadow in some map. If the body is the same again, so is the piece.
  struct Cast {
    CastBody body;
    std::optional<MapPiece> piece;

    [[nodiscard]] bool isOf(const CastBody& other) const {
      return body.map_from_mesh.matrix() == other.map_from_mesh.matrix() &&
             body.fronts_only == other.fronts_only;
    }
  };

  [[nodiscard]] Layer& layerOf(const ShadowProjection& shadow) {
    return layers_[static_cast<std::size_t>(shadow.map)];
  }
  [[nodiscard]] const Layer& layerOf(const ShadowProjection& shadow) const {
    return layers_[static_cast<std::size_t>(shadow.map)];
  }
  [[nodiscard]] ChangedTexels changedIn(const ShadowProjection& shadow) const;
  void begin();
  void paintStandingLayer(const ShadowProjection& shadow, const std::vector<Pose>& X_WL,
                          const LinkSelection& casting);
  void paintLayer(const ShadowProjection& shadow, const std::vector<Pose>& X_WL,
                  const LinkSelection& casting, const LinkSelection& moving);
  [[nodiscard]] bool isCastByRaster(const ShadowProjection& shadow, const std::vector<Pose>& X_WL,
                                    const LinkSelection& casting, bool stand_still) const;
  [[nodiscard]] cv::Mat castStanding(const ShadowProjection& shadow, const std::vector<Pose>& X_WL,
                                     const LinkSelection& casting) const;
  [[nodiscard]] std::vector<MapPiece> castPieces(const ShadowProjection& shadow,
                                                 const std::vector<Pose>& X_WL,
                                                 const LinkSelection& casting);
  [[nodiscard]] std::vector<cv::Rect> texelsOfMoving(const ShadowProjection& shadow,
                                                     const std::vector<Pose>& X_WL,
                                                     const LinkSelection& casting) const;
  void draw(const ShadowProjection& shadow, const std::vector<Pose>& X_WL,
            const LinkSelection& casting, Casters casters);

  const GlFunctions& gl_;
  const DrawList& draw_list_;
  ShaderFamily programs_;
  ShadowMaps maps_;
  ShadowMaps sides_;
  bool has_glass_;  ///< if so, OpenGL needs the maps
  std::vector<Layer> layers_;
  std::map<std::pair<int, const DrawItem*>, Cast> casts_;  ///< by map and item
};

}  // namespace synthetic_dataset::render

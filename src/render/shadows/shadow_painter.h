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
/// top of it: depths are the least ones whatever the order, so a map's pixels do not tell.
/// Triangles are drawn by the processor; OpenGL draws what has holes or lies partly before a light,
/// and all where there is glass, whose shader looks the maps up.
class ShadowPainter {
 public:
  /// @param draw_list  have to outlive this
  ShadowPainter(const GlFunctions& gl, const DrawList& draw_list, const ShadowLayout& layout);

  /// @param moving  of each shadow, the links that are of interest among those that cast it and
  ///     move; empty for all
  /// @param casters  where links cast, if that is not quite X_WL
  void paint(const std::vector<ShadowProjection>& shadows, const std::vector<Pose>& X_WL,
             const LinkSelection& casting, const std::vector<LinkSelection>& moving = {},
             const CasterPoses* casters = nullptr);

  /// The shadows of what never moves alone.
  void paintStanding(const std::vector<ShadowProjection>& shadows, const std::vector<Pose>& X_WL,
                     const LinkSelection& casting);

  /// What paint() has just drawn beside what never moves, of each of these shadows.
  [[nodiscard]] std::vector<ChangedTexels> changedTexels(
      const std::vector<ShadowProjection>& shadows) const;

  /// What was drawn last.
  [[nodiscard]] MapDepths depths(const ShadowProjection& shadow) const;

  /// The same for OpenGL, where something is drawn that one can see through: all maps that are no
  /// sides, and all sides.
  [[nodiscard]] GLuint maps() const { return maps_.texture(); }
  [[nodiscard]] GLuint sides() const { return sides_.texture(); }

 private:
  enum class Casters { kAll, kStanding, kMoving };

  /// A map, and what it was drawn with last.
  struct Layer {
    ShadowMaps* maps;                 ///< among which it is
    int number;                       ///< among these
    std::vector<cv::Rect> overdrawn;  ///< texels where OpenGL drew beside what is kept

    Eigen::Matrix4d shadow_from_world = Eigen::Matrix4d::Zero();
    LinkSelection casting = {};
    bool is_kept = false;               ///< the standing casters, as they are drawn with these
    std::vector<MapPiece> moving = {};  ///< what moves, where it was drawn on top of them
    std::shared_ptr<MapDepths::Standing> standing = nullptr;  ///< or all, if they are not kept

    void begin(const ShadowProjection& shadow, const LinkSelection& casters);
    [[nodiscard]] bool isSame(const ShadowProjection& shadow, const LinkSelection& casters) const;
    [[nodiscard]] int size() const { return maps->whole().width; }
    [[nodiscard]] std::shared_ptr<MapDepths::Standing> readAll() const;
  };

  /// What an item was cast as last, in some map. The same again is the same piece.
  struct Cast {
    CastBody body;
    std::optional<MapPiece> piece;

    [[nodiscard]] bool isOf(const CastBody& other) const {
      return body.map_from_mesh.matrix() == other.map_from_mesh.matrix() &&
             body.fronts_alone == other.fronts_alone;
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
  bool has_glass_;  ///< which OpenGL lights
  std::vector<Layer> layers_;
  std::map<std::pair<int, const DrawItem*>, Cast> casts_;  ///< by map and part
};

}  // namespace synthetic_dataset::render

#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "render/parts/bounding_hull.h"
#include "render/parts/bounds.h"
#include "render/parts/mesh_library.h"
#include "render/parts/shader_family.h"
#include "render/parts/texture_library.h"
#include "render/render_options.h"
#include "render/view.h"
#include "world/world.h"

namespace synthetic_dataset::render {

/// The OpenGL names of a material's textures; 0 for none.
struct ItemTextures {
  GLuint diffuse = 0;
  GLuint normal = 0;
  GLuint roughness = 0;
  GLuint metalness = 0;
  GLuint emissive = 0;
};

/// Where a blended texture's alpha is below this, labels do not show it (docs/labels.md, "Glass").
constexpr float kLeastOpacity = 0.1F;
constexpr float kOpaque = 0.9F;  ///< the same limit if labels do not show see-through surfaces

/// One surface of one link, ready to be drawn.
struct DrawItem {
  const MeshBuffers* mesh = nullptr;
  const world::Mesh* shape = nullptr;         ///< the same mesh, as it was read
  const world::Material* given = nullptr;     ///< the material that the item was made with
  const world::Material* material = nullptr;  ///< with which it is drawn now
  ItemTextures textures;
  SurfaceFeatures features = 0;
  std::size_t link = 0;
  std::uint32_t identifier = 0;  ///< the object's index + 1; 0 for the world
  Pose X_LV = Pose::Identity();
  Bounds bounds_V;
  const BoundingHull* hull_V =
      nullptr;               ///< tighter than the bounds; set if the item moves or is transparent
  bool transparent = false;  ///< somewhere; then it casts no shadow
  bool casts_shadow = true;
  bool casts_by_front = false;  ///< the backs of its triangles add nothing to its shadow
  bool stands_still = false;    ///< the link never moves
  bool double_sided = false;
  bool has_holes = false;        ///< where its texture's alpha is small
  float alpha_threshold = 0.5F;  ///< below it are holes; in glass, only for labels

  /// Labels show what is behind it instead.
  bool seen_through_in_labels = false;
};

/// Extends bounds in the world by an item, unless it has no triangles.
void extend(Bounds& bounds, const DrawItem& item, const Pose& X_WL);

/// Everything that can be drawn, uploaded once.
class DrawList {
 public:
  /// @param links  have to outlive the list
  /// @param simulator  whose lighting model is used: colours are linear for gz-sim, sRGB-encoded
  ///     for Gazebo Classic
  /// @param glass  which transparent items labels show
  DrawList(const GlFunctions& gl, const std::vector<world::LinkInstance>& links,
           world::Simulator simulator, GlassInLabels glass = GlassInLabels::kOfObjects);

  [[nodiscard]] world::Simulator simulator() const { return simulator_; }
  [[nodiscard]] bool isClassic() const { return simulator_ == world::Simulator::kClassic; }

  [[nodiscard]] const std::vector<DrawItem>& items() const { return items_; }

  /// Sets the items' materials from now on. Whether they are transparent, double-sided or have
  /// holes does not change, so that pictures that are being finished are not disturbed.
  void setMaterials(const std::map<const world::Material*, world::Material>& materials);

  /// The index of one of items(), counted from 1.
  [[nodiscard]] std::uint32_t numberOf(const DrawItem& item) const {
    return static_cast<std::uint32_t>(&item - items_.data()) + 1;
  }

  /// All features that any item has.
  [[nodiscard]] SurfaceFeatures features() const { return features_; }

  /// Bounds of all selected items that cast shadows, with up to half a metre to spare for items
  /// that move.
  [[nodiscard]] Bounds casterBounds(const std::vector<Pose>& X_WL,
                                    const LinkSelection& casting) const;

  /// Those of the given links that never move.
  [[nodiscard]] LinkSelection standing(const LinkSelection& links) const;

  /// Whether there is a transparent item that labels show nevertheless.
  [[nodiscard]] bool hasGlassInLabels(const LinkSelection& drawn) const;

  /// The selected opaque items, nearest first.
  /// @param stands_still  whether to return those that never move, or those that may
  [[nodiscard]] std::vector<const DrawItem*> solidItems(const Pose& X_CW,
                                                        const std::vector<Pose>& X_WL,
                                                        const LinkSelection& drawn,
                                                        bool stands_still) const;

  /// The selected transparent items, farthest first.
  [[nodiscard]] std::vector<const DrawItem*> transparentItems(const Pose& X_CW,
                                                              const std::vector<Pose>& X_WL,
                                                              const LinkSelection& drawn) const;

 private:
  [[nodiscard]] DrawItem makeItem(const std::shared_ptr<const world::Mesh>& mesh,
                                  const world::Material& material);
  void place(const world::Visual& visual, const world::Surface& surface, DrawItem& item);
  void seeThroughInLabels(DrawItem& item) const;
  void dress(DrawItem& item);
  [[nodiscard]] const BoundingHull& hullOf(const world::Mesh& mesh);
  [[nodiscard]] bool isSurfaceOfBodies(const std::shared_ptr<const world::Mesh>& mesh);

  /// Wanted items, sorted by the depth of their bounds' centres times `sign`, the least first.
  [[nodiscard]] std::vector<const DrawItem*> sorted(
      const Pose& X_CW, const std::vector<Pose>& X_WL, const LinkSelection& drawn, double sign,
      const std::function<bool(const DrawItem&)>& wanted) const;

  world::Simulator simulator_;
  GlassInLabels glass_;
  MeshLibrary meshes_;
  TextureLibrary textures_;
  SurfaceFeatures features_ = 0;
  std::vector<DrawItem> items_;
  std::map<const world::Mesh*, bool> surfaces_of_bodies_;  ///< of meshes examined so far
  std::map<const world::Mesh*, BoundingHull> hulls_;
  std::map<const world::Material*, world::Material> varied_;
};

}  // namespace synthetic_dataset::render

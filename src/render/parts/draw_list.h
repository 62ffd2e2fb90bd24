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

/// A material's pictures as OpenGL names them; 0 for none.
struct ItemTextures {
  GLuint diffuse = 0;
  GLuint normal = 0;
  GLuint roughness = 0;
  GLuint metalness = 0;
  GLuint emissive = 0;
};

/// A blended texture whose alpha is less is not there for labels (docs/labels.md, "Glass").
constexpr float kLeastOpacity = 0.1F;
constexpr float kOpaque = 0.9F;  ///< the same where labels leave out what one can see through

/// One surface of one link, ready to be drawn.
struct DrawItem {
  const MeshBuffers* mesh = nullptr;
  const world::Mesh* shape = nullptr;         ///< the same, as it was read
  const world::Material* given = nullptr;     ///< the material that it was made with
  const world::Material* material = nullptr;  ///< in which it is drawn now
  ItemTextures textures;
  SurfaceFeatures features = 0;
  std::size_t link = 0;
  std::uint32_t identifier = 0;  ///< the object's index + 1; 0 for the world
  Pose X_LV = Pose::Identity();
  Bounds bounds_V;
  const BoundingHull* hull_V =
      nullptr;               ///< closer than the bounds; of what moves or is transparent
  bool transparent = false;  ///< somewhere; it casts no shadow then
  bool casts_shadow = true;
  bool casts_by_front = false;  ///< the backs of its triangles add nothing to its shadow
  bool stands_still = false;    ///< the link is of what never moves
  bool double_sided = false;
  bool has_holes = false;        ///< where its texture's alpha is small
  float alpha_threshold = 0.5F;  ///< below it: of glass, where labels have it no more

  /// Labels leave it out, and do not hide what is behind it.
  bool seen_through_in_labels = false;
};

/// Grows bounds in the world by an item; not by one without triangles.
void extend(Bounds& bounds, const DrawItem& item, const Pose& X_WL);

/// All that can be drawn, uploaded once.
class DrawList {
 public:
  /// @param links  have to outlive the list
  /// @param simulator  whose light falls on it: colours are linear for gz-sim's, sRGB-encoded for
  ///     Gazebo Classic's
  /// @param glass  which of what is transparent labels show
  DrawList(const GlFunctions& gl, const std::vector<world::LinkInstance>& links,
           world::Simulator simulator, GlassInLabels glass = GlassInLabels::kOfObjects);

  [[nodiscard]] world::Simulator simulator() const { return simulator_; }
  [[nodiscard]] bool isClassic() const { return simulator_ == world::Simulator::kClassic; }

  [[nodiscard]] const std::vector<DrawItem>& items() const { return items_; }

  /// Gives the items their materials from now on. What they are, transparent or double-sided or
  /// with holes, stays, so that pictures that are being finished are not disturbed.
  void setMaterials(const std::map<const world::Material*, world::Material>& materials);

  /// The index of one of items(), counted from 1.
  [[nodiscard]] std::uint32_t numberOf(const DrawItem& item) const {
    return static_cast<std::uint32_t>(&item - items_.data()) + 1;
  }

  /// All that some part has.
  [[nodiscard]] SurfaceFeatures features() const { return features_; }

  /// Around all selected items that cast shadows, with up to half a metre to spare where they move.
  [[nodiscard]] Bounds casterBounds(const std::vector<Pose>& X_WL,
                                    const LinkSelection& casting) const;

  /// The links that never move.
  [[nodiscard]] LinkSelection standing(const LinkSelection& links) const;

  /// Whether one can see through something that labels show all the same.
  [[nodiscard]] bool hasGlassInLabels(const LinkSelection& drawn) const;

  /// The selected items that one cannot see through, nearest first.
  /// @param stands_still  those that do, or those that do not
  [[nodiscard]] std::vector<const DrawItem*> solidItems(const Pose& X_CW,
                                                        const std::vector<Pose>& X_WL,
                                                        const LinkSelection& drawn,
                                                        bool stands_still) const;

  /// The selected items that one can see through, farthest first.
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

  /// By the depth of their bounds' centres times `sign`, the least first.
  [[nodiscard]] std::vector<const DrawItem*> sorted(
      const Pose& X_CW, const std::vector<Pose>& X_WL, const LinkSelection& drawn, double sign,
      const std::function<bool(const DrawItem&)>& wanted) const;

  world::Simulator simulator_;
  GlassInLabels glass_;
  MeshLibrary meshes_;
  TextureLibrary textures_;
  SurfaceFeatures features_ = 0;
  std::vector<DrawItem> items_;
  std::map<const world::Mesh*, bool> surfaces_of_bodies_;  ///< of those looked at so far
  std::map<const world::Mesh*, BoundingHull> hulls_;
  std::map<const world::Material*, world::Material> varied_;
};

}  // namespace synthetic_dataset::render

#pragma once

#include <optional>
#include <set>
#include <vector>

#include "render/draw_list.h"
#include "render/light_setup.h"
#include "render/shader_family.h"
#include "render/sky_painter.h"
#include "render/view.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// What all surfaces of a picture have in common. The references have to outlive it.
struct ColourScene {
  const View& view;
  const std::vector<Pose>& X_WL;
  const LinkSelection& drawn;
  const std::vector<ShadowProjection>& shadows;
  float exposure = 1.0F;
};

/// Draws surfaces in colour into the bound target. Of surfaces at the same place that stands which
/// never moves, of several of them the last one; otherwise the order makes no difference.
class ColourPainter {
 public:
  /// @param parts  has to outlive this
  ColourPainter(const GlFunctions& gl, const DrawList& parts,
                const world::Description& description);

  /// All that is selected.
  void paint(const ColourScene& scene, GLuint shadow_maps);

  /// The same in two steps: what never moves, without what one can see through, with the sky behind
  /// it; and all else.
  void paintStanding(const ColourScene& scene, GLuint shadow_maps);
  void paintTheRest(const ColourScene& scene, GLuint shadow_maps);

  /// Linear.
  [[nodiscard]] const Eigen::Vector3f& background() const { return background_; }

 private:
  void begin(GLuint shadow_maps);
  void drawMoving(const ColourScene& scene);
  void drawStanding(const ColourScene& scene);
  void drawSeenThrough(const ColourScene& scene);
  void draw(const ColourScene& scene, const Part& part);
  void setSurroundings(const ShaderProgram& program, const ColourScene& scene) const;
  void setMaterial(const ShaderProgram& program, const Part& part) const;
  void setFog(const ShaderProgram& program) const;

  const GlFunctions& gl_;
  const DrawList& parts_;
  std::vector<world::Light> lights_;
  Eigen::Vector3f ambient_;
  Eigen::Vector3f background_;
  std::optional<world::Fog> fog_;
  ShaderFamily programs_;
  std::optional<SkyPainter> sky_;
  std::set<const ShaderProgram*> prepared_;  ///< that know the surroundings
};

}  // namespace synthetic_dataset::render

#pragma once

#include <optional>
#include <vector>

#include <opencv2/core/types.hpp>

#include "render/light/colour_scene.h"
#include "render/overlay/background_painter.h"
#include "render/overlay/sky_painter.h"
#include "render/parts/shader_family.h"
#include "render/shadows/shadow_painter.h"
#include "world/description.h"
#include "world/look.h"

namespace synthetic_dataset::render {

/// Draws what is behind and before the surfaces of a picture that one cannot see through, in the
/// bound framebuffer.
class OverlayPainter {
 public:
  /// @param draw_list  has to outlive this
  /// @param detail  the most that scenes ask for
  OverlayPainter(const GlFunctions& gl, const DrawList& draw_list,
                 const world::Description& description, LightDetail detail);

  /// Lights and surroundings from now on; the items' materials are read from them.
  void setLook(const world::Look& look);

  /// Whether more than one colour is behind all surfaces.
  [[nodiscard]] bool hasBackground() const { return background_painter_.hasPicture() || sky_; }

  /// Whether one can see through something that is selected.
  [[nodiscard]] bool hasGlass(const LinkSelection& drawn) const;

  /// A picture or the sky, and what one can see through, if that is selected and `see_through`.
  /// @param regions  of the picture, none of them over another; beside them nothing is sure
  void paint(const ColourScene& scene, const ShadowPainter& shadows, bool see_through,
             const std::vector<cv::Rect>& regions);

 private:
  void drawSeenThrough(const ColourScene& scene);
  void setSurroundings(const ShaderProgram& program, const ColourScene& scene) const;
  void setLight(const ShaderProgram& program, const world::Material& material) const;
  void setFog(const ShaderProgram& program) const;
  [[nodiscard]] SurfaceFeatures featuresOf(const ColourScene& scene) const;

  const GlFunctions& gl_;
  const DrawList& draw_list_;
  std::vector<world::Light> lights_;
  std::vector<std::size_t> on_glass_;  ///< of these
  Eigen::Vector3f ambient_;            ///< sRGB-encoded
  std::optional<world::Fog> fog_;
  ShaderFamily glass_programs_;
  BackgroundPainter background_painter_;
  std::optional<SkyPainter> sky_;
};

}  // namespace synthetic_dataset::render

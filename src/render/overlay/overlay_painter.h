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

/// Draws what is behind and in front of the opaque surfaces of a picture, in the bound framebuffer.
class OverlayPainter {
 public:
  /// @param draw_list  has to outlive this painter
  /// @param detail  the highest that scenes request
  OverlayPainter(const GlFunctions& gl, const DrawList& draw_list,
                 const world::Description& description, LightDetail detail);

  /// Sets lights and surroundings from now on; materials are read from the draw list's items.
  void setLook(const world::Look& look);

  /// Whether there is more than a single colour behind all surfaces.
  [[nodiscard]] bool hasBackground() const { return background_painter_.hasPicture() || sky_; }

  /// Whether any selected link is transparent.
  [[nodiscard]] bool hasGlass(const LinkSelection& drawn) const;

  /// Paints a background picture or the sky, and, with `see_through`, the selected links'
  /// transparent surfaces.
  /// @param regions  of the picture, which must not overlap; pixels outside them are undefined
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
  std::vector<std::size_t> on_glass_;  ///< indices in lights_
  Eigen::Vector3f ambient_;            ///< sRGB-encoded
  std::optional<world::Fog> fog_;
  ShaderFamily glass_programs_;
  BackgroundPainter background_painter_;
  std::optional<SkyPainter> sky_;
};

}  // namespace synthetic_dataset::render

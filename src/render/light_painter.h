#pragma once

#include <optional>
#include <vector>

#include <opencv2/core/types.hpp>

#include "render/background_painter.h"
#include "render/draw_list.h"
#include "render/geometry_buffer.h"
#include "render/light_setup.h"
#include "render/rectangle_drawing.h"
#include "render/shader_family.h"
#include "render/sky_painter.h"
#include "render/view.h"
#include "world/description.h"
#include "world/look.h"

namespace synthetic_dataset::render {

/// What all surfaces of a picture have in common. The references have to outlive it.
struct ColourScene {
  const View& view;
  const std::vector<Pose>& X_WL;
  const LinkSelection& drawn;
  const std::vector<ShadowProjection>& shadows;
  float exposure = 1.0F;

  /// Through a lens: what it sees, of which `view` is a face.
  const View* whole = nullptr;
};

/// Lights what was drawn into a GeometryBuffer, in the bound LightTarget.
class LightPainter {
 public:
  /// @param parts  has to outlive this
  LightPainter(const GlFunctions& gl, const DrawList& parts, const world::Description& description);

  /// Lights and surroundings from now on; what the parts wear is read from them.
  void setLook(const world::Look& look);

  /// The lit surfaces, a picture, the sky or the background's colour behind them, and what one can
  /// see through before them, if that is selected and `see_through`.
  /// @param regions  of the picture, none of them over another; beside them nothing is sure
  void paint(const ColourScene& scene, const GeometryBuffer& geometry, GLuint shadow_maps,
             bool see_through, const std::vector<cv::Rect>& regions);

  /// What a picture shows where nothing is, neither sky nor another picture: blue, green, red,
  /// sRGB-encoded.
  [[nodiscard]] cv::Scalar backgroundPixel(float exposure) const;

 private:
  void light(const ColourScene& scene, const GeometryBuffer& geometry,
             const std::vector<cv::Rect>& regions);
  void drawSeenThrough(const ColourScene& scene);
  void setSurroundings(const ShaderProgram& program, const ColourScene& scene) const;
  void setFog(const ShaderProgram& program) const;
  [[nodiscard]] SurfaceFeatures featuresOf(const ColourScene& scene) const;

  const GlFunctions& gl_;
  const DrawList& parts_;
  std::vector<world::Light> lights_;
  Eigen::Vector3f ambient_;
  Eigen::Vector3f background_;
  std::optional<world::Fog> fog_;
  ShaderFamily light_programs_;
  ShaderFamily glass_programs_;
  BackgroundPainter background_painter_;
  std::optional<SkyPainter> sky_;
  GlTexture materials_;
  RectangleDrawing drawing_;
};

}  // namespace synthetic_dataset::render

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/geometry/geometry_images.h"
#include "render/gl/framebuffer.h"
#include "render/light/ambient_occlusion.h"
#include "render/light/colour_scene.h"
#include "render/light/surface_lighter.h"
#include "render/overlay/environment.h"
#include "render/overlay/overlay_painter.h"
#include "render/shadows/shadow_painter.h"

namespace synthetic_dataset::render {

/// What the pixels' centres see.
struct SeenSurfaces {
  GeometryImages geometry;
  SurfaceImages surfaces;
  cv::Rect place;  ///< of these pixels in the picture

  /// CV_32FC3, of the picture: the pixels' rays, along which depths are measured; empty for a
  /// pinhole camera.
  cv::Mat rays = {};

  /// The surfaces that may occlude ambient light; nothing with simple light.
  std::optional<Occluders> occluders = std::nullopt;
};

/// Pixels whose light is still to be computed, at any time and in any thread.
struct UnlitPixels {
  SeenSurfaces seen;
  std::vector<cv::Rect> regions;  ///< of the picture; contain all wanted pixels
  cv::Mat wanted;  ///< CV_8UC1, of the picture: not 0 for wanted pixels; others are undefined
  Intrinsics intrinsics;  ///< of the picture
  LightingContext context;
  std::shared_ptr<const std::vector<ItemLight>> items;
  Eigen::Vector3f nothing;  ///< the light where there is no surface, in the surfaces' form
  cv::Mat overlay;          ///< CV_16UC4, half floats: linear red, green, blue, and as alpha the
                            ///< share of the surfaces' light that passes; empty for none

  /// @return CV_16UC4 of the place of `seen`, half floats: linear red, green, blue, and 1
  [[nodiscard]] cv::Mat light() const;
};

/// Gathers what is needed to compute the light of what was drawn into a geometry buffer.
class LightPainter {
 public:
  /// @param draw_list  has to outlive this painter
  /// @param detail  the highest that scenes request
  LightPainter(const GlFunctions& gl, const DrawList& draw_list,
               const world::Description& description, LightDetail detail);

  /// Sets lights and surroundings from now on; materials are read from the draw list's items.
  void setLook(const world::Look& look);

  /// Gathers what the light of surfaces is computed from; with a background picture, the sky or the
  /// background's colour behind them and, with `see_through`, the selected transparent items in
  /// front of them.
  /// @param shadows  as drawn for the scene
  /// @param target  has the depth of what is seen
  /// @param regions  of the picture; do not overlap, and contain all wanted pixels
  /// @param wanted  CV_8UC1, of the picture: not 0 for the wanted pixels; all others are undefined
  [[nodiscard]] UnlitPixels paint(const ColourScene& scene, const SeenSurfaces& seen,
                                  const ShadowPainter& shadows, const Framebuffer& target,
                                  bool see_through, const std::vector<cv::Rect>& regions,
                                  const cv::Mat& wanted);

  /// The same for a picture with a single colour behind all surfaces and nothing in front of them.
  [[nodiscard]] UnlitPixels surfacesAlone(const ColourScene& scene, const SeenSurfaces& seen,
                                          const ShadowPainter& shadows,
                                          const std::vector<cv::Rect>& regions,
                                          const cv::Mat& wanted);

  /// Whether a picture of these links has more than a single colour behind them, or transparent
  /// items.
  [[nodiscard]] bool hasOverlay(const LinkSelection& drawn) const {
    return overlay_painter_.hasBackground() || overlay_painter_.hasGlass(drawn);
  }

  /// What a picture shows where there is nothing, neither sky nor background picture: blue, green,
  /// red, sRGB-encoded.
  [[nodiscard]] cv::Scalar backgroundPixel(float exposure) const;

 private:
  void findPartLights();
  [[nodiscard]] Eigen::Vector3f nothing(float exposure) const;
  [[nodiscard]] LightingContext context(const ColourScene& scene, const ShadowPainter& shadows);

  const DrawList& draw_list_;
  std::vector<world::Light> lights_;
  world::Simulator simulator_;
  Eigen::Vector3f ambient_;     ///< sRGB-encoded
  Eigen::Vector3f background_;  ///< sRGB-encoded
  std::optional<world::Fog> fog_;
  std::shared_ptr<const std::vector<ItemLight>> item_lights_;
  Environment environment_;
  OverlayPainter overlay_painter_;
};

}  // namespace synthetic_dataset::render

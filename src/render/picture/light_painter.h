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

  /// CV_32FC3 of the picture: what pixels look along, in whose lengths depths are; empty for those
  /// of a pinhole.
  cv::Mat rays = {};

  /// What may hide these from the light that is everywhere; nothing with simple light.
  std::optional<Occluders> occluders = std::nullopt;
};

/// Pixels whose light is to be found, when and in which thread ever.
struct UnlitPixels {
  SeenSurfaces seen;
  std::vector<cv::Rect> regions;  ///< of the picture, around those that are wanted
  cv::Mat wanted;         ///< CV_8UC1 of the picture: not 0 for these; what others hold is not sure
  Intrinsics intrinsics;  ///< of the picture
  LightingContext context;
  std::shared_ptr<const std::vector<ItemLight>> items;
  Eigen::Vector3f nothing;  ///< the light where no surface is, as surfaces' is found
  cv::Mat overlay;          ///< CV_16UC4: red, green, blue, linear, and as alpha how much of the
                            ///< surfaces' light passes; numbers of 16 bits; empty for none

  /// @return CV_16UC4 of the place of `seen`: red, green, blue, 1, linear, numbers of 16 bits
  [[nodiscard]] cv::Mat light() const;
};

/// Gathers what it takes to find the light of what was drawn into a geometry buffer.
class LightPainter {
 public:
  /// @param draw_list  has to outlive this
  /// @param detail  the most that scenes ask for
  LightPainter(const GlFunctions& gl, const DrawList& draw_list,
               const world::Description& description, LightDetail detail);

  /// Lights and surroundings from now on; what the items look like is read from them.
  void setLook(const world::Look& look);

  /// What the light of surfaces is found from; with a picture, the sky or the background's colour
  /// behind them, and what one can see through before them, if that is selected and `see_through`.
  /// @param shadows  as they were drawn for the scene
  /// @param target  with the depth of what is seen
  /// @param regions  of the picture, none of them over another, around the pixels that are wanted
  /// @param wanted  CV_8UC1 of the picture: not 0 for these; of others nothing is sure
  [[nodiscard]] UnlitPixels paint(const ColourScene& scene, const SeenSurfaces& seen,
                                  const ShadowPainter& shadows, const Framebuffer& target,
                                  bool see_through, const std::vector<cv::Rect>& regions,
                                  const cv::Mat& wanted);

  /// The same of a picture with one colour behind all surfaces and nothing before them.
  [[nodiscard]] UnlitPixels surfacesAlone(const ColourScene& scene, const SeenSurfaces& seen,
                                          const ShadowPainter& shadows,
                                          const std::vector<cv::Rect>& regions,
                                          const cv::Mat& wanted);

  /// Whether something else is behind these links, or before them, in a picture.
  [[nodiscard]] bool hasOverlay(const LinkSelection& drawn) const {
    return overlay_painter_.hasBackground() || overlay_painter_.hasGlass(drawn);
  }

  /// What a picture shows where nothing is, neither sky nor another picture: blue, green, red,
  /// sRGB-encoded.
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

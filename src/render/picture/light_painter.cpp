#include "render/picture/light_painter.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <opencv2/core.hpp>

#include "render/light/light_setup.h"
#include "render/pixels/encoded_light.h"
#include "render/pixels/lane_images.h"
#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {
namespace {

bool showsNothing(const SeenSurfaces& seen, const std::vector<cv::Rect>& regions) {
  return std::any_of(regions.begin(), regions.end(), [&](const cv::Rect& region) {
    const cv::Mat items = seen.geometry.items(region - seen.place.tl());
    return cv::countNonZero(items) < static_cast<int>(items.total());
  });
}

/// @param surfaces, overlay  CV_16UC4; the overlay's alpha is the share of the surfaces' light that
///     passes
cv::Mat laidOver(const cv::Mat& surfaces, const cv::Mat& overlay) {
  const cv::Mat light = render::widened(surfaces);
  const cv::Mat before = render::widened(overlay);
  cv::Mat result(light.size(), CV_16UC4);
  for (int v = 0; v < light.rows; ++v) {
    const auto* below = light.ptr<std::uint16_t>(v);
    const auto* above = before.ptr<std::uint16_t>(v);
    auto* to = result.ptr<std::uint16_t>(v);
    for (int u = 0; u < light.cols; u += kLaneCount) {
      const int first = 4 * firstLane(u, light.cols);
      const PixelLanes over = loadHalves(above + first);
      storeHalves(to + first, over.xyz + loadHalves(below + first).xyz * over.w);
    }
  }
  return result.colRange(0, surfaces.cols);
}

}  // namespace

cv::Mat UnlitPixels::light() const {
  if (regions.empty()) return {};
  const SurfaceLighter lighter(context, *items, intrinsics, nothing, seen.rays);
  const cv::Mat which = wanted(seen.place);
  cv::Mat open;
  if (seen.occluders)
    open = ambientVisibility(*seen.occluders, seen.geometry.normals, seen.place, which);
  cv::Mat result = lighter.light(seen.geometry, seen.surfaces, seen.place, regions, which, open);
  if (!overlay.empty()) result = laidOver(result, overlay);
  if (context.simulator == world::Simulator::kClassic) {
    std::vector<cv::Rect> pixels;
    for (const cv::Rect& region : regions) pixels.push_back(region - seen.place.tl());
    exposeEncoded(result, context.exposure, pixels);
  }
  return result;
}

LightPainter::LightPainter(const GlFunctions& gl, const DrawList& draw_list,
                           const world::Description& description, LightDetail detail)
    : draw_list_(draw_list),
      lights_(description.lights),
      simulator_(description.simulator),
      ambient_(description.ambient),
      background_(description.background),
      fog_(description.fog),
      environment_(gl, description),
      overlay_painter_(gl, draw_list, description, detail) {
  findPartLights();
}

void LightPainter::setLook(const world::Look& look) {
  lights_ = look.lights;
  ambient_ = look.ambient;
  background_ = look.background;
  findPartLights();
  overlay_painter_.setLook(look);
  environment_.setLook(look);
}

void LightPainter::findPartLights() {
  item_lights_ =
      std::make_shared<std::vector<ItemLight>>(itemLights(draw_list_.items(), simulator_));
}

/// The background's light, in the form that surfaces' light has.
Eigen::Vector3f LightPainter::nothing(float exposure) const {
  if (overlay_painter_.hasBackground()) return Eigen::Vector3f::Zero();
  if (simulator_ == world::Simulator::kClassic) return background_;
  return exposure * linearFromSrgb(background_);
}

UnlitPixels LightPainter::paint(const ColourScene& scene, const SeenSurfaces& seen,
                                const ShadowPainter& shadows, const Framebuffer& target,
                                bool see_through, const std::vector<cv::Rect>& regions,
                                const cv::Mat& wanted) {
  const bool has_background = overlay_painter_.hasBackground();
  UnlitPixels result = surfacesAlone(scene, seen, shadows, regions, wanted);
  see_through = see_through && overlay_painter_.hasGlass(scene.drawn);
  if (see_through || (has_background && showsNothing(seen, regions))) {
    constexpr std::array<float, 4> kAllPasses = {0.0F, 0.0F, 0.0F, 1.0F};
    target.bind(target.size(), seen.place);
    target.clear(0, kAllPasses);
    overlay_painter_.paint(scene, shadows, see_through, regions);
    result.overlay = target.read(0, seen.place);
  }
  return result;
}

UnlitPixels LightPainter::surfacesAlone(const ColourScene& scene, const SeenSurfaces& seen,
                                        const ShadowPainter& shadows,
                                        const std::vector<cv::Rect>& regions,
                                        const cv::Mat& wanted) {
  return {seen,
          regions,
          wanted,
          scene.view.camera.intrinsics(),
          context(scene, shadows),
          item_lights_,
          nothing(scene.exposure),
          {}};
}

LightingContext LightPainter::context(const ColourScene& scene, const ShadowPainter& shadows) {
  const bool is_classic = simulator_ == world::Simulator::kClassic;
  LightingContext result{lightsIn(scene.view, lights_),
                         {},
                         is_classic ? ambient_ : linearFromSrgb(ambient_),
                         upIn(scene.view),
                         scene.exposure,
                         fog_,
                         simulator_};
  result.shadows.resize(result.lights.size());
  if (scene.detail == LightDetail::kFull) {
    result.environment = environment_.light();
    result.R_GC = scene.view.X_WC.linear().cast<float>();
  }
  for (const ShadowProjection& shadow : scene.shadows) {
    result.shadows[static_cast<std::size_t>(shadow.light)].push_back(
        {shadows.depths(shadow), shadow.shadow_from_world * scene.view.X_WC.matrix(), shadow.texel,
         shadow.softness});
  }
  return result;
}

cv::Scalar LightPainter::backgroundPixel(float exposure) const {
  const Eigen::Vector3f light = exposure * linearFromSrgb(background_);
  const auto encoded = [&](Eigen::Index channel) { return render::srgbFromLinear(light[channel]); };
  return {static_cast<double>(encoded(2)), static_cast<double>(encoded(1)),
          static_cast<double>(encoded(0))};
}

}  // namespace synthetic_dataset::render

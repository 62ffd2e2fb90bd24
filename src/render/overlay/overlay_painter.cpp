#include "render/overlay/overlay_painter.h"

#include <algorithm>
#include <set>
#include <string>

#include "render/gl/shader_program.h"
#include "render/light/light_setup.h"
#include "render/parts/item_surface.h"
#include "render/parts/surface_drawing.h"
#include "render/pixels/encoded_light.h"
#include "render/pixels/srgb.h"
#include "render/shaders.h"

namespace synthetic_dataset::render {
namespace {

constexpr SurfaceFeatures kAllFeatures = ~SurfaceFeatures{0};

std::string macrosOf(const DrawList& draw_list, const std::vector<world::Light>& lights,
                     LightDetail detail) {
  return (draw_list.isClassic() ? "#define CLASSIC\n" : "") +
         lightMacros(lights, strongestLights(lights, kMostOnGlass), detail);
}

}  // namespace

OverlayPainter::OverlayPainter(const GlFunctions& gl, const DrawList& draw_list,
                               const world::Description& description, LightDetail detail)
    : gl_(gl),
      draw_list_(draw_list),
      lights_(description.lights),
      on_glass_(strongestLights(lights_, kMostOnGlass)),
      ambient_(description.ambient),
      fog_(description.fog),
      glass_programs_(gl, shaders::kMeshVertex, shaders::kGlassFragment, kAllFeatures,
                      macrosOf(draw_list, description.lights, detail)),
      background_painter_(gl, draw_list.isClassic()) {
  if (description.sky) sky_.emplace(gl, *description.sky, lights_, draw_list.isClassic());
}

void OverlayPainter::setLook(const world::Look& look) {
  lights_ = look.lights;
  ambient_ = look.ambient;
  background_painter_.setPicture(look.background_picture);
  if (sky_) sky_->setLights(lights_);
}

bool OverlayPainter::hasGlass(const LinkSelection& drawn) const {
  const std::vector<DrawItem>& items = draw_list_.items();
  return std::any_of(items.begin(), items.end(),
                     [&](const DrawItem& item) { return item.transparent && drawn[item.link]; });
}

void OverlayPainter::paint(const ColourScene& scene, const ShadowPainter& shadows, bool see_through,
                           const std::vector<cv::Rect>& regions) {
  gl_.BindTextureUnit(kShadowUnit, shadows.maps());
  gl_.BindTextureUnit(kShadowSideUnit, shadows.sides());
  gl_.DepthMask(GL_FALSE);
  gl_.DepthFunc(GL_GEQUAL);
  if (background_painter_.hasPicture()) {
    background_painter_.paint(scene.view, scene.whole, scene.exposure, regions);
  } else if (sky_) {
    sky_->paint(scene.view, scene.exposure, regions);
  }
  if (see_through) drawSeenThrough(scene);
  gl_.DepthMask(GL_TRUE);
}

void OverlayPainter::drawSeenThrough(const ColourScene& scene) {
  gl_.Enable(GL_BLEND);
  // Alpha keeps the share of light that passes.
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
  const Pose X_CW = scene.view.X_WC.inverse();
  std::set<const ShaderProgram*> prepared;
  for (const DrawItem* item : draw_list_.transparentItems(X_CW, scene.X_WL, scene.drawn)) {
    // What is a hole to the labels is blended nevertheless.
    const bool blends = (item->features & feature::kGlass) != 0;
    const SurfaceFeatures own = item->features & ~(blends ? feature::kHoles : SurfaceFeatures{0});
    const ShaderProgram& program = glass_programs_.get(own | featuresOf(scene));
    if (prepared.insert(&program).second) setSurroundings(program, scene);
    setMaterial(gl_, program, *item, draw_list_.simulator());
    setLight(program, *item->material);
    drawSurface(gl_, program, *item, scene.view, scene.X_WL[item->link]);
  }
  gl_.Disable(GL_BLEND);
}

/// Sets a program's uniforms for the light that is the same all over an item.
void OverlayPainter::setLight(const ShaderProgram& program, const world::Material& material) const {
  if (!draw_list_.isClassic()) {
    program.set("emissive", linearFromSrgb(material.emissive));
    program.set("reflectance", reflectance(material));
    return;
  }
  const ClassicLight light = classicLight(material);
  program.set("around", Eigen::Vector3f(light.ambient.cwiseProduct(ambient_) + light.emissive));
  program.set("diffuse_colour", light.diffuse);
  program.set("specular_colour", light.specular);
  program.set("shininess", light.shininess);
  program.set("emissive", light.glow);
}

SurfaceFeatures OverlayPainter::featuresOf(const ColourScene& scene) const {
  return render::featuresOf(scene.view) | (fog_ ? feature::kFog : SurfaceFeatures{0}) |
         (scene.shadows.empty() ? SurfaceFeatures{0} : feature::kShadows);
}

/// Sets a program's uniforms that are the same for all surfaces of a picture.
void OverlayPainter::setSurroundings(const ShaderProgram& program, const ColourScene& scene) const {
  program.set("ambient", linearFromSrgb(ambient_));
  program.set("brightest", brightestEncoded(scene.exposure));
  program.set("up_C", upIn(scene.view));
  setLights(program, lights_, on_glass_, scene.shadows, scene.view);
  setFog(program);
  program.set("exposure", scene.exposure);
}

void OverlayPainter::setFog(const ShaderProgram& program) const {
  if (!fog_) return;
  program.set("fog_type", static_cast<int>(fog_->type));
  program.set("fog_colour", draw_list_.isClassic() ? fog_->colour : linearFromSrgb(fog_->colour));
  program.set(
      "fog_extent",
      Eigen::Vector3f(Eigen::Vector3d(fog_->start, fog_->end, fog_->density).cast<float>()));
}

}  // namespace synthetic_dataset::render

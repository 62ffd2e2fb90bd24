#include "render/colour_painter.h"

#include <algorithm>

#include "render/shaders.h"
#include "render/srgb.h"
#include "render/surface_drawing.h"
#include "render/texture_units.h"

namespace synthetic_dataset::render {
namespace {

constexpr SurfaceFeatures kAllFeatures = ~SurfaceFeatures{0};

/// The light that a dielectric throws back head-on, from the strength of its specular colour
/// (Lagarde and de Rousiers 2014, "Moving Frostbite to PBR": 0.16 r^2).
float reflectance(const world::Material& material) {
  const float strength = std::clamp(material.specular.maxCoeff(), 0.0F, 1.0F);
  return 0.16F * strength * strength;
}

}  // namespace

ColourPainter::ColourPainter(const GlFunctions& gl, const DrawList& parts,
                             const world::Description& description)
    : gl_(gl),
      parts_(parts),
      lights_(description.lights),
      ambient_(linearFromSrgb(description.ambient)),
      background_(linearFromSrgb(description.background)),
      fog_(description.fog),
      programs_(gl, shaders::kMeshVertex, shaders::kColourFragment, kAllFeatures,
                lightMacros(description.lights)) {
  checkLightCount(lights_);
  if (description.sky) sky_.emplace(gl, *description.sky, lights_);
}

void ColourPainter::paint(const ColourScene& scene, GLuint shadow_maps) {
  begin(shadow_maps);
  drawMoving(scene);  // mostly in front of all else: what it hides is not shaded
  drawStanding(scene);
  drawSeenThrough(scene);
}

void ColourPainter::paintStanding(const ColourScene& scene, GLuint shadow_maps) {
  begin(shadow_maps);
  drawStanding(scene);
}

void ColourPainter::paintTheRest(const ColourScene& scene, GLuint shadow_maps) {
  begin(shadow_maps);
  drawMoving(scene);
  drawSeenThrough(scene);
}

void ColourPainter::begin(GLuint shadow_maps) {
  prepared_.clear();
  gl_.BindTextureUnit(kShadowUnit, shadow_maps);
}

void ColourPainter::drawMoving(const ColourScene& scene) {
  gl_.DepthFunc(GL_GREATER);
  const Pose X_CW = scene.view.X_WC.inverse();
  for (const Part* part : parts_.solidParts(X_CW, scene.X_WL, scene.drawn, false)) {
    draw(scene, *part);
  }
}

void ColourPainter::drawStanding(const ColourScene& scene) {
  gl_.DepthFunc(GL_GEQUAL);
  const Pose X_CW = scene.view.X_WC.inverse();
  for (const Part* part : parts_.solidParts(X_CW, scene.X_WL, scene.drawn, true)) {
    draw(scene, *part);
  }
  gl_.DepthMask(GL_FALSE);
  if (sky_) sky_->paint(scene.view, scene.exposure);
  gl_.DepthMask(GL_TRUE);
}

void ColourPainter::drawSeenThrough(const ColourScene& scene) {
  gl_.DepthFunc(GL_GEQUAL);
  gl_.DepthMask(GL_FALSE);
  gl_.Enable(GL_BLEND);
  const Pose X_CW = scene.view.X_WC.inverse();
  for (const Part* part : parts_.transparentParts(X_CW, scene.X_WL, scene.drawn)) {
    draw(scene, *part);
  }
  gl_.Disable(GL_BLEND);
  gl_.DepthMask(GL_TRUE);
}

void ColourPainter::draw(const ColourScene& scene, const Part& part) {
  const SurfaceFeatures common = (fog_ ? feature::kFog : SurfaceFeatures{0}) |
                                 (scene.shadows.empty() ? SurfaceFeatures{0} : feature::kShadows);
  const ShaderProgram& program = programs_.get(part.features | common);
  if (prepared_.insert(&program).second) setSurroundings(program, scene);
  setMaterial(program, part);
  drawSurface(gl_, program, part, scene.view, scene.X_WL[part.link]);
}

/// Tells a program what is the same for all surfaces of a picture.
void ColourPainter::setSurroundings(const ShaderProgram& program, const ColourScene& scene) const {
  const Eigen::Vector3d up_C = scene.view.X_WC.linear().transpose() * Eigen::Vector3d::UnitZ();
  program.set("ambient", ambient_);
  program.set("up_C", Eigen::Vector3f(up_C.cast<float>()));
  setLights(program, lights_, scene.shadows, scene.view);
  setFog(program);
  program.set("exposure", scene.exposure);
}

void ColourPainter::setMaterial(const ShaderProgram& program, const Part& part) const {
  const world::Material& material = *part.material;
  program.set("diffuse", linearFromSrgb(material.diffuse));
  program.set("emissive", linearFromSrgb(material.emissive));
  program.set("reflectance", reflectance(material));
  program.set("roughness", material.roughness);
  program.set("metalness", material.metalness);
  const PartTextures& textures = part.textures;
  if (textures.normal != 0) gl_.BindTextureUnit(kNormalUnit, textures.normal);
  if (textures.roughness != 0) gl_.BindTextureUnit(kRoughnessUnit, textures.roughness);
  if (textures.metalness != 0) gl_.BindTextureUnit(kMetalnessUnit, textures.metalness);
  if (textures.emissive != 0) gl_.BindTextureUnit(kEmissiveUnit, textures.emissive);
}

void ColourPainter::setFog(const ShaderProgram& program) const {
  if (!fog_) return;
  program.set("fog_type", static_cast<int>(fog_->type));
  program.set("fog_colour", linearFromSrgb(fog_->colour));
  program.set(
      "fog_extent",
      Eigen::Vector3f(Eigen::Vector3d(fog_->start, fog_->end, fog_->density).cast<float>()));
}

}  // namespace synthetic_dataset::render

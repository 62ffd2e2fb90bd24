#include "render/light_painter.h"

#include <set>
#include <string>

#include "render/material_setup.h"
#include "render/shaders.h"
#include "render/srgb.h"
#include "render/surface_drawing.h"
#include "render/texture_units.h"
#include "sensor/srgb.h"

namespace synthetic_dataset::render {
namespace {

constexpr SurfaceFeatures kAllFeatures = ~SurfaceFeatures{0};
constexpr SurfaceFeatures kOfLight =
    feature::kNormalMap | feature::kEmissiveMap | feature::kFog | feature::kShadows;
constexpr int kPartsInRow = 1024;

int rowsFor(const std::vector<Part>& parts) {
  return static_cast<int>(parts.size()) / kPartsInRow + 1;
}

GlTexture makeMaterialTable(const GlFunctions& gl, const std::vector<Part>& parts) {
  GlTexture texture = makeTexture(gl, GL_TEXTURE_2D);
  gl.TextureStorage2D(texture.name(), 1, GL_RGBA32F, kPartsInRow, rowsFor(parts));
  return texture;
}

/// What light.frag reads of each part.
void fillMaterialTable(const GlFunctions& gl, const std::vector<Part>& parts,
                       const GlTexture& texture) {
  const int rows = rowsFor(parts);
  std::vector<Eigen::Vector4f> table(static_cast<std::size_t>(rows) * kPartsInRow,
                                     Eigen::Vector4f::Zero());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const world::Material& material = *parts[i].material;
    const Eigen::Vector3f emissive = linearFromSrgb(material.emissive);
    table[i] = {emissive.x(), emissive.y(), emissive.z(),
                material.lit ? reflectance(material) : -1.0F};
  }
  gl.TextureSubImage2D(texture.name(), 0, 0, 0, kPartsInRow, rows, GL_RGBA, GL_FLOAT, table.data());
}

}  // namespace

LightPainter::LightPainter(const GlFunctions& gl, const DrawList& parts,
                           const world::Description& description)
    : gl_(gl),
      parts_(parts),
      lights_(description.lights),
      ambient_(linearFromSrgb(description.ambient)),
      background_(linearFromSrgb(description.background)),
      fog_(description.fog),
      light_programs_(gl, shaders::kRectanglesVertex, shaders::kLightFragment, kOfLight,
                      lightMacros(description.lights) + "#define PARTS_IN_ROW " +
                          std::to_string(kPartsInRow) + "\n"),
      glass_programs_(gl, shaders::kMeshVertex, shaders::kGlassFragment, kAllFeatures,
                      lightMacros(description.lights)),
      background_painter_(gl),
      materials_(makeMaterialTable(gl, parts.parts())),
      drawing_(gl) {
  checkLightCount(lights_);
  fillMaterialTable(gl, parts.parts(), materials_);
  if (description.sky) sky_.emplace(gl, *description.sky, lights_);
}

void LightPainter::setLook(const world::Look& look) {
  lights_ = look.lights;
  ambient_ = linearFromSrgb(look.ambient);
  background_ = linearFromSrgb(look.background);
  fillMaterialTable(gl_, parts_.parts(), materials_);
  background_painter_.setPicture(look.background_picture);
  if (sky_) sky_->setLights(lights_);
}

void LightPainter::paint(const ColourScene& scene, const GeometryBuffer& geometry,
                         GLuint shadow_maps, bool see_through,
                         const std::vector<cv::Rect>& regions) {
  gl_.BindTextureUnit(kShadowUnit, shadow_maps);
  gl_.DepthMask(GL_FALSE);
  light(scene, geometry, regions);
  gl_.DepthFunc(GL_GEQUAL);
  if (background_painter_.hasPicture()) {
    background_painter_.paint(scene.view, scene.whole, scene.exposure, regions);
  } else if (sky_) {
    sky_->paint(scene.view, scene.exposure, regions);
  }
  if (see_through) drawSeenThrough(scene);
  gl_.DepthMask(GL_TRUE);
}

void LightPainter::light(const ColourScene& scene, const GeometryBuffer& geometry,
                         const std::vector<cv::Rect>& regions) {
  const ShaderProgram& program = light_programs_.get(featuresOf(scene) | parts_.features());
  setSurroundings(program, scene);
  const Intrinsics& k = scene.view.camera.intrinsics();
  program.set("intrinsics", Eigen::Vector4f(Eigen::Vector4d(k.fx, k.fy, k.cx, k.cy).cast<float>()));
  program.set("background", Eigen::Vector3f(scene.exposure * background_));
  geometry.bindTextures();
  gl_.BindTextureUnit(kMaterialsUnit, materials_.name());
  gl_.Disable(GL_DEPTH_TEST);
  drawing_.draw(program, regions, {scene.view.camera.width(), scene.view.camera.height()});
  gl_.Enable(GL_DEPTH_TEST);
}

void LightPainter::drawSeenThrough(const ColourScene& scene) {
  gl_.Enable(GL_BLEND);
  const Pose X_CW = scene.view.X_WC.inverse();
  std::set<const ShaderProgram*> prepared;
  for (const Part* part : parts_.transparentParts(X_CW, scene.X_WL, scene.drawn)) {
    const ShaderProgram& program = glass_programs_.get(part->features | featuresOf(scene));
    if (prepared.insert(&program).second) setSurroundings(program, scene);
    setMaterial(gl_, program, *part);
    program.set("emissive", linearFromSrgb(part->material->emissive));
    program.set("reflectance", reflectance(*part->material));
    drawSurface(gl_, program, *part, scene.view, scene.X_WL[part->link]);
  }
  gl_.Disable(GL_BLEND);
}

cv::Scalar LightPainter::backgroundPixel(float exposure) const {
  const auto encoded = [&](Eigen::Index channel) {
    return sensor::srgbFromLinear(exposure * background_[channel]);
  };
  return {static_cast<double>(encoded(2)), static_cast<double>(encoded(1)),
          static_cast<double>(encoded(0))};
}

SurfaceFeatures LightPainter::featuresOf(const ColourScene& scene) const {
  return (fog_ ? feature::kFog : SurfaceFeatures{0}) |
         (scene.shadows.empty() ? SurfaceFeatures{0} : feature::kShadows);
}

/// Tells a program what is the same for all surfaces of a picture.
void LightPainter::setSurroundings(const ShaderProgram& program, const ColourScene& scene) const {
  const Eigen::Vector3d up_C = scene.view.X_WC.linear().transpose() * Eigen::Vector3d::UnitZ();
  program.set("ambient", ambient_);
  program.set("up_C", Eigen::Vector3f(up_C.cast<float>()));
  setLights(program, lights_, scene.shadows, scene.view);
  setFog(program);
  program.set("exposure", scene.exposure);
}

void LightPainter::setFog(const ShaderProgram& program) const {
  if (!fog_) return;
  program.set("fog_type", static_cast<int>(fog_->type));
  program.set("fog_colour", linearFromSrgb(fog_->colour));
  program.set(
      "fog_extent",
      Eigen::Vector3f(Eigen::Vector3d(fog_->start, fog_->end, fog_->density).cast<float>()));
}

}  // namespace synthetic_dataset::render

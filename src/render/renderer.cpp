#include "render/renderer.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "render/lens_library.h"
#include "render/lens_resampling.h"
#include "render/light_setup.h"
#include "render/osmesa_context.h"
#include "render/shader_family.h"
#include "render/shaders.h"
#include "render/shadow_painter.h"
#include "render/sky_painter.h"
#include "render/srgb.h"
#include "render/surface_drawing.h"
#include "render/texture_units.h"
#include "sensor/srgb.h"

namespace synthetic_dataset::render {
namespace {

using ImageSize = std::pair<int, int>;

constexpr SurfaceFeatures kAllFeatures = ~SurfaceFeatures{0};

/// The light that a dielectric throws back head-on, from the strength of its specular colour
/// (Lagarde and de Rousiers 2014, "Moving Frostbite to PBR": 0.16 r^2).
float reflectance(const world::Material& material) {
  const float strength = std::clamp(material.specular.maxCoeff(), 0.0F, 1.0F);
  return 0.16F * strength * strength;
}

ImageSize sizeOf(const CameraModel& camera) { return {camera.width(), camera.height()}; }

}  // namespace

struct Renderer::Impl {
  Impl(const world::Description& description, const std::vector<world::LinkInstance>& links,
       const RenderOptions& render_options)
      : options(render_options),
        lights(description.lights),
        ambient(linearFromSrgb(description.ambient)),
        background(linearFromSrgb(description.background)),
        fog(description.fog),
        gl(context.gl()),
        colour_programs(gl, shaders::kMeshVertex, shaders::kColourFragment, kAllFeatures,
                        lightMacros(description.lights)),
        draw_list(gl, links),
        shadow_painter(gl, draw_list, options.shadow_map_size, shadowCount(description.lights)),
        label_painter(gl, draw_list, lenses),
        silhouette_painter(gl, draw_list, lenses) {
    checkLightCount(lights);
    gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl.FrontFace(GL_CW);  // the image is drawn with its first row at the bottom
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.Enable(GL_DEPTH_TEST);
    if (description.sky) sky.emplace(gl, *description.sky, lights);
  }

  void setMaterial(const ShaderProgram& program, const Part& part) const {
    const world::Material& material = *part.material;
    program.set("diffuse", linearFromSrgb(material.diffuse));
    program.set("emissive", linearFromSrgb(material.emissive));
    program.set("reflectance", reflectance(material));
    program.set("roughness", material.roughness);
    program.set("metalness", material.metalness);
    const PartTextures& textures = part.textures;
    if (textures.normal != 0) gl.BindTextureUnit(kNormalUnit, textures.normal);
    if (textures.roughness != 0) gl.BindTextureUnit(kRoughnessUnit, textures.roughness);
    if (textures.metalness != 0) gl.BindTextureUnit(kMetalnessUnit, textures.metalness);
    if (textures.emissive != 0) gl.BindTextureUnit(kEmissiveUnit, textures.emissive);
  }

  void setFog(const ShaderProgram& program) const {
    if (!fog) return;
    program.set("fog_type", static_cast<int>(fog->type));
    program.set("fog_colour", linearFromSrgb(fog->colour));
    program.set("fog_extent",
                Eigen::Vector3f(Eigen::Vector3d(fog->start, fog->end, fog->density).cast<float>()));
  }

  /// Tells a program what is the same for all surfaces of a picture.
  void setSurroundings(const ShaderProgram& program, const View& view,
                       const std::vector<ShadowProjection>& shadows, float exposure) const {
    const Eigen::Vector3d up_C = view.X_WC.linear().transpose() * Eigen::Vector3d::UnitZ();
    program.set("ambient", ambient);
    program.set("up_C", Eigen::Vector3f(up_C.cast<float>()));
    setLights(program, lights, shadows, view);
    setFog(program);
    program.set("exposure", exposure);
  }

  /// Draws the selected parts into the bound colour target: solid ones, the sky behind them, then
  /// those that one can see through.
  void drawColours(const View& view, const std::vector<Pose>& X_WL, const ColourPass& pass,
                   const std::vector<ShadowProjection>& shadows) {
    const SurfaceFeatures common = (fog ? feature::kFog : SurfaceFeatures{0}) |
                                   (shadows.empty() ? SurfaceFeatures{0} : feature::kShadows);
    std::set<const ShaderProgram*> prepared;
    const auto draw = [&](const Part& part) {
      const ShaderProgram& program = colour_programs.get(part.features | common);
      if (prepared.insert(&program).second) {
        setSurroundings(program, view, shadows, pass.exposure);
      }
      setMaterial(program, part);
      drawSurface(gl, program, part, view, X_WL[part.link]);
    };
    gl.BindTextureUnit(kShadowUnit, shadow_painter.texture());
    const Pose X_CW = view.X_WC.inverse();
    gl.DepthFunc(GL_GREATER);
    for (const Part* part : draw_list.solidParts(X_CW, X_WL, pass.drawn)) draw(*part);
    gl.DepthMask(GL_FALSE);
    gl.DepthFunc(GL_GEQUAL);
    if (sky) sky->paint(view, pass.exposure);
    gl.Enable(GL_BLEND);
    for (const Part* part : draw_list.transparentParts(X_CW, X_WL, pass.drawn)) {
      draw(*part);
    }
    gl.Disable(GL_BLEND);
    gl.DepthMask(GL_TRUE);
  }

  /// @param region  the part that is drawn
  cv::Mat drawPinhole(const View& view, const std::vector<Pose>& X_WL, const ColourPass& pass,
                      const std::optional<cv::Rect>& region,
                      const std::vector<ShadowProjection>& shadows) {
    const ColourTarget& target = colourTarget(view.camera, pass.sampling);
    const Eigen::Vector3f exposed = pass.exposure * background;
    target.begin(exposed.data());
    if (region) {
      gl.Enable(GL_SCISSOR_TEST);
      gl.Scissor(region->x, region->y, region->width, region->height);
    }
    drawColours(view, X_WL, pass, shadows);
    gl.Disable(GL_SCISSOR_TEST);
    return target.read();
  }

  cv::Mat drawThroughLens(const View& view, const std::vector<Pose>& X_WL, const ColourPass& pass,
                          const std::vector<ShadowProjection>& shadows) {
    const LensMap& lens = lenses.get(view.camera);
    const cv::Rect image(0, 0, view.camera.width(), view.camera.height());
    const cv::Rect region = pass.region.value_or(image) & image;
    const auto encoded = [&](Eigen::Index i) {
      return sensor::srgbFromLinear(pass.exposure * background[i]);
    };
    cv::Mat picture(image.size(), CV_8UC3, cv::Scalar(encoded(2), encoded(1), encoded(0)));
    picture.setTo(cv::Scalar::all(0), lens.face < 0);
    const std::vector<View> views = faceViews(lens, view);
    for (std::size_t face = 0; face < views.size(); ++face) {
      const cv::Rect needed = neededOf(lens, face, region);
      if (needed.empty()) continue;
      const cv::Mat drawn = drawPinhole(views[face], X_WL, pass, needed, shadows);
      const bool smooth = pass.sampling == Sampling::kSmooth;
      (smooth ? resampleSmooth : resampleCentres)(lens, face, drawn, region, picture);
    }
    return picture;
  }

  const ColourTarget& colourTarget(const CameraModel& camera, Sampling sampling) {
    auto& targets = sampling == Sampling::kSmooth ? smooth_targets : centre_targets;
    const int samples = sampling == Sampling::kSmooth ? options.samples : 1;
    return targets.try_emplace(sizeOf(camera), gl, camera.width(), camera.height(), samples)
        .first->second;
  }

  RenderOptions options;
  std::vector<world::Light> lights;
  Eigen::Vector3f ambient;
  Eigen::Vector3f background;
  std::optional<world::Fog> fog;

  OsmesaContext context;  // before all that lives in it
  const GlFunctions& gl;
  ShaderFamily colour_programs;
  DrawList draw_list;
  ShadowPainter shadow_painter;
  LensLibrary lenses;
  LabelPainter label_painter;
  SilhouettePainter silhouette_painter;
  std::optional<SkyPainter> sky;
  std::map<ImageSize, ColourTarget> smooth_targets;
  std::map<ImageSize, ColourTarget> centre_targets;
};

Renderer::Renderer(const world::Description& description,
                   const std::vector<world::LinkInstance>& links, const RenderOptions& options)
    : impl_(std::make_unique<Impl>(description, links, options)) {}

Renderer::~Renderer() = default;

cv::Mat Renderer::colour(const View& view, const std::vector<Pose>& X_WL, const ColourPass& pass) {
  Impl& impl = *impl_;
  const bool distorted = hasDistortion(view.camera);
  const auto shadows = shadowProjections(
      impl.lights,
      distorted ? faceViews(impl.lenses.get(view.camera), view) : std::vector<View>{view},
      impl.draw_list.casterBounds(X_WL, pass.casting), impl.options.shadow_distance,
      impl.options.shadow_map_size);
  impl.shadow_painter.paint(shadows, X_WL, pass.casting);
  return distorted ? impl.drawThroughLens(view, X_WL, pass, shadows)
                   : impl.drawPinhole(view, X_WL, pass, pass.region, shadows);
}

LabelImages Renderer::labels(const View& view, const std::vector<Pose>& X_WL,
                             const LabelPass& pass) {
  return impl_->label_painter.paint(view, X_WL, pass);
}

Silhouette Renderer::silhouette(const View& view, const std::vector<Pose>& X_WL,
                                const LinkSelection& links) {
  return impl_->silhouette_painter.paint(view, X_WL, links);
}

std::string Renderer::glVersion() const { return impl_->context.version(); }

}  // namespace synthetic_dataset::render

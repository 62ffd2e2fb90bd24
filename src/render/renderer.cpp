#include "render/renderer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "render/light_setup.h"
#include "render/osmesa_context.h"
#include "render/shader_program.h"
#include "render/shaders.h"
#include "render/shadow_maps.h"

namespace synthetic_dataset::render {
namespace {

using ImageSize = std::pair<int, int>;

constexpr GLuint kDiffuseUnit = 0;
constexpr GLuint kShadowUnit = 1;

/// sRGB's transfer function (IEC 61966-2-1).
float linearFromSrgb(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

Eigen::Vector3f linearFromSrgb(const Eigen::Vector3f& encoded) {
  return encoded.unaryExpr([](float channel) { return linearFromSrgb(channel); });
}

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
        gl(context.gl()),
        colour_program(gl, shaders::kMeshVertex, shaders::kColourFragment),
        label_program(gl, shaders::kMeshVertex, shaders::kLabelFragment),
        depth_program(gl, shaders::kMeshVertex, shaders::kShadowFragment),
        shadow_program(gl, shaders::kShadowVertex, shaders::kShadowFragment),
        draw_list(gl, links),
        shadow_maps(gl, options.shadow_map_size, shadowCount(description.lights)) {
    checkLightCount(lights);
    gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl.FrontFace(GL_CW);  // the image is drawn with its first row at the bottom
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.Enable(GL_DEPTH_TEST);
    for (const auto* program : {&colour_program, &label_program, &depth_program, &shadow_program}) {
      program->set("diffuse_map", static_cast<int>(kDiffuseUnit));
    }
    colour_program.set("shadow_maps", static_cast<int>(kShadowUnit));
  }

  void bindTexture(const ShaderProgram& program, const Part& part) const {
    program.set("textured", part.texture != 0 ? 1 : 0);
    if (part.texture != 0) gl.BindTextureUnit(kDiffuseUnit, part.texture);
  }

  void drawShadows(const std::vector<ShadowProjection>& shadows, const std::vector<Pose>& X_WL,
                   const LinkSelection& casting) const {
    gl.Enable(GL_DEPTH_CLAMP);  // what stands before the map's range still casts
    gl.DepthFunc(GL_LESS);
    gl.Disable(GL_CULL_FACE);
    shadow_program.use();
    for (const ShadowProjection& shadow : shadows) {
      shadow_maps.begin(shadow.layer);
      for (const Part& part : draw_list.parts()) {
        if (!part.casts_shadow || !casting[part.link]) continue;
        const Eigen::Matrix4d shadow_from_mesh =
            shadow.shadow_from_world * (X_WL[part.link] * part.X_LV).matrix();
        shadow_program.set("shadow_from_mesh", Eigen::Matrix4f(shadow_from_mesh.cast<float>()));
        bindTexture(shadow_program, part);
        part.mesh->draw();
      }
    }
    gl.Disable(GL_DEPTH_CLAMP);
  }

  /// Starts drawing what the camera sees with a program.
  void useForCamera(const ShaderProgram& program, const View& view) const {
    program.use();
    program.set("clip_from_camera", Eigen::Matrix4f(clipFromCamera(view.camera).cast<float>()));
  }

  void drawPart(const ShaderProgram& program, const Part& part, const Pose& X_CW,
                const std::vector<Pose>& X_WL) const {
    if (part.material->double_sided) {
      gl.Disable(GL_CULL_FACE);
    } else {
      gl.Enable(GL_CULL_FACE);
    }
    const Pose X_CV = X_CW * X_WL[part.link] * part.X_LV;
    program.set("camera_from_mesh", Eigen::Matrix4f(X_CV.matrix().cast<float>()));
    bindTexture(program, part);
    part.mesh->draw();
  }

  void setMaterial(const world::Material& material) const {
    Eigen::Vector4f diffuse;
    diffuse << linearFromSrgb(Eigen::Vector3f(material.diffuse.head<3>())), material.diffuse.w();
    colour_program.set("diffuse", diffuse);
    colour_program.set("emissive", linearFromSrgb(material.emissive));
    colour_program.set("reflectance", reflectance(material));
    colour_program.set("roughness", material.roughness);
    colour_program.set("metalness", material.metalness);
  }

  /// Depth first: lighting is the costly part, and is then done only for what is seen.
  void drawDepth(const View& view, const Pose& X_CW, const std::vector<Pose>& X_WL,
                 const LinkSelection& drawn) const {
    gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl.DepthFunc(GL_GREATER);
    useForCamera(depth_program, view);
    for (const Part& part : draw_list.parts()) {
      if (drawn[part.link] && !part.transparent()) drawPart(depth_program, part, X_CW, X_WL);
    }
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }

  /// Draws the selected parts into the bound colour target: solid ones, then those that one can
  /// see through.
  void drawColours(const View& view, const std::vector<Pose>& X_WL, const LinkSelection& drawn,
                   const std::vector<ShadowProjection>& shadows) const {
    const Pose X_CW = view.X_WC.inverse();
    const Eigen::Vector3d up_C = X_CW.linear() * Eigen::Vector3d::UnitZ();
    drawDepth(view, X_CW, X_WL, drawn);
    useForCamera(colour_program, view);
    colour_program.set("ambient", ambient);
    colour_program.set("up_C", Eigen::Vector3f(up_C.cast<float>()));
    setLights(colour_program, lights, shadows, view);
    gl.BindTextureUnit(kShadowUnit, shadow_maps.texture());
    gl.DepthMask(GL_FALSE);
    gl.DepthFunc(GL_GEQUAL);
    for (const Part& part : draw_list.parts()) {
      if (!drawn[part.link] || part.transparent()) continue;
      setMaterial(*part.material);
      drawPart(colour_program, part, X_CW, X_WL);
    }
    gl.Enable(GL_BLEND);
    for (const Part* part : draw_list.transparentParts(X_CW, X_WL, drawn)) {
      setMaterial(*part->material);
      drawPart(colour_program, *part, X_CW, X_WL);
    }
    gl.Disable(GL_BLEND);
    gl.DepthMask(GL_TRUE);
  }

  const ColourTarget& colourTarget(const CameraModel& camera, Sampling sampling) {
    auto& targets = sampling == Sampling::kSmooth ? smooth_targets : centre_targets;
    const int samples = sampling == Sampling::kSmooth ? options.samples : 1;
    return targets.try_emplace(sizeOf(camera), gl, camera.width(), camera.height(), samples)
        .first->second;
  }

  const LabelTarget& labelTarget(const CameraModel& camera) {
    return label_targets.try_emplace(sizeOf(camera), gl, camera.width(), camera.height())
        .first->second;
  }

  RenderOptions options;
  std::vector<world::Light> lights;
  Eigen::Vector3f ambient;
  Eigen::Vector3f background;

  OsmesaContext context;  // before all that lives in it
  const GlFunctions& gl;
  ShaderProgram colour_program;
  ShaderProgram label_program;
  ShaderProgram depth_program;
  ShaderProgram shadow_program;
  DrawList draw_list;
  ShadowMaps shadow_maps;
  std::map<ImageSize, ColourTarget> smooth_targets;
  std::map<ImageSize, ColourTarget> centre_targets;
  std::map<ImageSize, LabelTarget> label_targets;
};

Renderer::Renderer(const world::Description& description,
                   const std::vector<world::LinkInstance>& links, const RenderOptions& options)
    : impl_(std::make_unique<Impl>(description, links, options)) {}

Renderer::~Renderer() = default;

cv::Mat Renderer::colour(const View& view, const std::vector<Pose>& X_WL, const ColourPass& pass) {
  Impl& impl = *impl_;
  const auto shadows =
      shadowProjections(impl.lights, view, impl.draw_list.casterBounds(X_WL, pass.casting),
                        impl.options.shadow_distance, impl.options.shadow_map_size);
  impl.drawShadows(shadows, X_WL, pass.casting);

  const ColourTarget& target = impl.colourTarget(view.camera, pass.sampling);
  impl.gl.Enable(GL_FRAMEBUFFER_SRGB);
  target.begin(impl.background.data());
  if (pass.region) {
    const cv::Rect& region = *pass.region;
    impl.gl.Enable(GL_SCISSOR_TEST);
    impl.gl.Scissor(region.x, region.y, region.width, region.height);
  }
  impl.drawColours(view, X_WL, pass.drawn, shadows);
  impl.gl.Disable(GL_SCISSOR_TEST);
  cv::Mat image = target.read();
  impl.gl.Disable(GL_FRAMEBUFFER_SRGB);
  return image;
}

LabelImages Renderer::labels(const View& view, const std::vector<Pose>& X_WL,
                             const LinkSelection& drawn) {
  Impl& impl = *impl_;
  const Pose X_CW = view.X_WC.inverse();
  const LabelTarget& target = impl.labelTarget(view.camera);
  target.begin();
  impl.gl.DepthFunc(GL_GREATER);
  impl.useForCamera(impl.label_program, view);
  for (const Part& part : impl.draw_list.parts()) {
    const bool seen_through = part.transparent() && part.identifier == 0;
    if (!drawn[part.link] || seen_through) continue;
    impl.label_program.set("identifier", part.identifier);
    impl.drawPart(impl.label_program, part, X_CW, X_WL);
  }
  return target.read();
}

}  // namespace synthetic_dataset::render

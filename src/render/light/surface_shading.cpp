#include "render/light/surface_shading.h"

#include "render/light/environment_response.h"
#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {
namespace {

Lanes3 fresnel(const Lanes3& f0, const Lanes& cosine) {
  const Lanes x = lanes(1.0F) - cosine;
  const Lanes x2 = x * x;
  return f0 + (lanes(1.0F, 1.0F, 1.0F) - f0) * (x2 * x2 * x);
}

/// The share of the ambient light that arrives, with interreflection between surfaces of the same
/// colour (Jimenez et al. 2016, a fit to path-traced scenes).
Lanes reaching(const Lanes& ambient_visibility, const Lanes& albedo) {
  const Lanes a = lanes(2.0404F) * albedo - lanes(0.3324F);
  const Lanes b = lanes(-4.7951F) * albedo + lanes(0.6417F);
  const Lanes c = lanes(2.7552F) * albedo + lanes(0.6903F);
  return cv::v_min(
      cv::v_max(ambient_visibility,
                ((ambient_visibility * a + b) * ambient_visibility + c) * ambient_visibility),
      lanes(1.0F));
}

Lanes3 reaching(const Lanes& ambient_visibility, const Lanes3& albedo) {
  if (cv::v_check_all(ambient_visibility == lanes(1.0F))) return lanes(1.0F, 1.0F, 1.0F);
  return {reaching(ambient_visibility, albedo.x), reaching(ambient_visibility, albedo.y),
          reaching(ambient_visibility, albedo.z)};
}

/// Linear up to 0.8, then bending towards 1, so that bright surfaces keep their details.
Lanes shoulder(const Lanes& linear) {
  constexpr float kStart = 0.8F;
  constexpr float kRest = 1.0F - kStart;
  const Lanes is_bright = linear > lanes(kStart);
  if (!cv::v_check_any(is_bright)) return linear;
  const Lanes fading = exponential((lanes(kStart) - linear) * lanes(1.0F / kRest));
  return cv::v_select(is_bright, lanes(1.0F) - lanes(kRest) * fading, linear);
}

}  // namespace

SurfaceShading::SurfaceShading(const LightingContext& context)
    : context_(context), lights_(context) {
  if (!context.fog) return;
  fog_light_ = context.exposure * linearFromSrgb(context.fog->colour);
}

Lanes3 SurfaceShading::seen(const SurfaceLanes& surface,
                            const std::vector<std::size_t>& lights) const {
  const Lanes exposure = lanes(context_.exposure);
  Lanes3 light = lit(surface, lights) * exposure;
  light = {shoulder(light.x), shoulder(light.y), shoulder(light.z)};
  light = select(surface.is_lit, light, surface.base * exposure);
  if (context_.fog) {
    light = mix(light, lanes(fog_light_), lights_.fogginess(length(surface.position_C)));
  }
  const Lanes one = lanes(1.0F);
  return {cv::v_min(light.x, one), cv::v_min(light.y, one), cv::v_min(light.z, one)};
}

/// The light that a surface emits and reflects to the camera.
Lanes3 SurfaceShading::lit(const SurfaceLanes& surface,
                           const std::vector<std::size_t>& lights) const {
  const Lanes one = lanes(1.0F);
  Response response;
  response.to_eye = normalized(lanes(0.0F, 0.0F, 0.0F) - surface.position_C);
  response.f0 = mix({surface.reflectance, surface.reflectance, surface.reflectance}, surface.base,
                    surface.metalness);
  response.matte = surface.base * (one - surface.metalness);
  response.alpha = cv::v_max(surface.roughness * surface.roughness, lanes(0.01F));
  response.n_dot_v = cv::v_max(dot(surface.normal, response.to_eye), lanes(1e-3F));

  Lanes3 sum = ambient(surface, response) + surface.glow;
  for (const std::size_t i : lights) sum = sum + reflected(i, surface, response);
  return sum;
}

/// The ambient light that a surface reflects to the camera.
Lanes3 SurfaceShading::ambient(const SurfaceLanes& surface, const Response& response) const {
  const Lanes one = lanes(1.0F);
  const Lanes3 matte = response.matte * reaching(surface.ambient_visibility, surface.base);
  if (context_.environment != nullptr) {
    return imageBasedLight(*context_.environment, surface, response, matte);
  }
  const Lanes3 mirrored = fresnel(response.f0, response.n_dot_v) *
                          mix(one, lanes(0.4F), surface.roughness) * surface.ambient_visibility;
  const Lanes half = lanes(0.5F);
  const Lanes sky = half + half * dot(surface.normal, lanes(context_.up_C));
  const Lanes3 around = lanes(context_.ambient) * mix(lanes(kAmbientFromBelow), one, sky);
  return around * (matte + mirrored);
}

/// The light of the environment that a surface reflects to the camera.
/// @param matte  the share of it that is reflected diffusely
Lanes3 SurfaceShading::imageBasedLight(const EnvironmentLight& environment,
                                       const SurfaceLanes& surface, const Response& response,
                                       const Lanes3& matte) const {
  const auto inWorld = [this](const Lanes3& direction_C) {
    return rotated(context_.R_GC, direction_C);
  };
  const Lanes3 mirrored =
      mirroredShare(response.f0, surface.roughness, response.n_dot_v) *
      mirroredOpenness(surface.ambient_visibility, surface.roughness, response.n_dot_v);
  const Lanes3 direction = mirroredDirection(surface.normal, response.to_eye, surface.roughness);
  return environment.arriving(inWorld(surface.normal)) * matte +
         environment.mirrored(inWorld(direction), surface.roughness) * mirrored;
}

/// The light of one light source that a surface reflects to the camera.
Lanes3 SurfaceShading::reflected(std::size_t light, const SurfaceLanes& surface,
                                 const Response& response) const {
  const Lanes zero = lanes(0.0F);
  const Arriving coming = lights_.at(light, surface.position_C);
  const Lanes n_dot_l = dot(surface.normal, coming.to_light);
  const Lanes faces =
      (n_dot_l > zero) & (dot(surface.face, coming.to_light) > zero) & (coming.falling > zero);
  if (!cv::v_check_any(faces)) return {zero, zero, zero};
  const Lanes passing =
      n_dot_l * lights_.passing(light, surface.position_C, surface.face, coming, faces);
  const Lanes3 halfway = normalized(coming.to_light + response.to_eye);
  const Lanes n_dot_h = cv::v_max(dot(surface.normal, halfway), zero);
  const Lanes v_dot_h = cv::v_max(dot(response.to_eye, halfway), zero);
  const Lanes& alpha = response.alpha;
  const Lanes& n_dot_v = response.n_dot_v;
  const Lanes a2 = alpha * alpha;
  const Lanes bell = n_dot_h * n_dot_h * (a2 - lanes(1.0F)) + lanes(1.0F);
  const Lanes rough = mix(lanes(2.0F) * n_dot_l * n_dot_v, n_dot_l + n_dot_v, alpha);
  // Lights are defined such that a white matte surface facing one of intensity 1 is just white: the
  // division by pi is left out of the diffuse term, and compensated in the specular one.
  const Lanes shine = lanes(0.5F) * a2 / (bell * bell * rough);
  const Lanes3 answer = response.matte + fresnel(response.f0, v_dot_h) * shine;
  // The answer may be infinite where the surface does not face the light.
  return select(faces, lanes(context_.lights[light].intensity) * coming.falling * answer * passing,
                {zero, zero, zero});
}

}  // namespace synthetic_dataset::render

#include "render/light/classic_shading.h"

#include "render/pixels/encoded_light.h"

namespace synthetic_dataset::render {

ClassicShading::ClassicShading(const LightingContext& context)
    : context_(context), lights_(context) {}

Lanes3 ClassicShading::seen(const ClassicLanes& surface,
                            const std::vector<std::size_t>& lights) const {
  const Lanes3 nothing = lanes(0.0F, 0.0F, 0.0F);
  Sums sums{nothing, nothing};
  for (const std::size_t i : lights) add(i, surface, sums);
  // Encoded values are about the square root of light.
  const Lanes3 around =
      surface.ambient * ambientLight(surface) * cv::v_sqrt(surface.ambient_visibility) +
      surface.emissive;
  Lanes3 light = (around + surface.diffuse * sums.diffuse) * surface.albedo +
                 surface.specular * sums.specular + surface.glow;
  const Lanes most = lanes(brightestEncoded(context_.exposure));
  light = {cv::v_min(light.x, most), cv::v_min(light.y, most), cv::v_min(light.z, most)};
  if (!context_.fog) return light;
  return mix(light, lanes(context_.fog->colour), lights_.fogginess(length(surface.position_C)));
}

/// The encoded ambient light, or that of the environment if there is one.
Lanes3 ClassicShading::ambientLight(const ClassicLanes& surface) const {
  if (context_.environment == nullptr) return lanes(context_.ambient);
  const Lanes3 light = context_.environment->arriving(rotated(context_.R_GC, surface.normal));
  return {cv::v_sqrt(light.x), cv::v_sqrt(light.y), cv::v_sqrt(light.z)};
}

void ClassicShading::add(std::size_t light, const ClassicLanes& surface, Sums& sums) const {
  const Lanes zero = lanes(0.0F);
  const LightInView& source = context_.lights[light];
  const Arriving coming = lights_.at(light, surface.position_C);
  const Lanes n_dot_l = dot(surface.normal, coming.to_light);
  const Lanes faces = (n_dot_l > zero) & (coming.falling > zero);
  if (!cv::v_check_any(faces)) return;
  // The normal on the side on which the light falls.
  const Lanes is_back = dot(surface.face, coming.to_light) < zero;
  const Lanes3 side = select(is_back, lanes(0.0F, 0.0F, 0.0F) - surface.face, surface.face);
  const Lanes passing = lights_.passing(light, surface.position_C, side, coming, faces);
  const Lanes share = (coming.falling * passing) & faces;
  sums.diffuse = sums.diffuse + lanes(source.intensity) * (n_dot_l * share);
  const Lanes shines = (surface.shininess > zero) & faces;
  if (!cv::v_check_any(shines)) return;
  const Lanes3 to_eye = normalized(lanes(0.0F, 0.0F, 0.0F) - surface.position_C);
  const Lanes n_dot_h = dot(surface.normal, normalized(coming.to_light + to_eye));
  const Lanes highlight = power(clamped(n_dot_h, 0.0F, 1.0F), surface.shininess) & shines;
  sums.specular = sums.specular + lanes(source.specular) * (highlight * share);
}

}  // namespace synthetic_dataset::render

#include "render/light/light_setup.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace synthetic_dataset::render {
std::string lightMacros(const std::vector<world::Light>& lights,
                        const std::vector<std::size_t>& chosen, LightDetail detail) {
  const ShadowLayout layout = shadowLayout(lights, 1, detail);
  const std::string shadows =
      "#define SHADOW_RAISE " + std::to_string(kShadowRaise) + "\n#define GRAZING_SHADOW_RAISE " +
      std::to_string(kGrazingShadowRaise) + "\n#define SHADOW_MAPS " + std::to_string(layout.maps) +
      "\n#define SHADOW_COUNT " + std::to_string(std::max(layout.maps + layout.sides, 1)) +
      "\n#define LIGHT_COUNT " + std::to_string(std::max<std::size_t>(chosen.size(), 1)) + "\n";
  // Each unrolled light takes time to compile, in every program.
  constexpr std::size_t kMostUnrolled = 8;
  std::string each;
  std::string types;
  std::string first_maps;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const std::string type = std::to_string(static_cast<int>(lights[chosen[i]].type));
    const std::string first = std::to_string(layout.first_maps[chosen[i]]);
    if (i < kMostUnrolled) each += " LIGHT(" + std::to_string(i) + "," + type + "," + first + ")";
    types += (i > 0 ? "," : "") + type;
    first_maps += (i > 0 ? "," : "") + first;
  }
  if (chosen.size() <= kMostUnrolled) return shadows + "#define EACH_LIGHT" + each + "\n";
  const std::string list = "const int kTypes[] = int[](" + types + ");\n" +
                           "const int kFirstMaps[] = int[](" + first_maps + ");\n";
  return shadows + list + "#define EACH_LIGHT" + each +
         " for (int i = " + std::to_string(kMostUnrolled) + "; i < " +
         std::to_string(chosen.size()) + "; ++i) { LIGHT(i, kTypes[i], kFirstMaps[i]) }\n";
}

std::vector<LightInView> lightsIn(const View& view, const std::vector<world::Light>& lights) {
  const Pose X_CW = view.X_WC.inverse();
  std::vector<LightInView> result;
  for (const world::Light& light : lights) {
    const Eigen::Vector3d position = X_CW * light.X_WL.translation();
    const Eigen::Vector3d direction =
        (X_CW.linear() * light.X_WL.linear() * light.direction_L).normalized();
    const Eigen::Vector3d attenuation(light.attenuation_constant, light.attenuation_linear,
                                      light.attenuation_quadratic);
    const Eigen::Vector3d cone(std::cos(0.5 * light.spot_inner_angle),
                               std::cos(0.5 * light.spot_outer_angle), light.spot_falloff);
    result.push_back({light.type, position.cast<float>(), direction.cast<float>(), light.diffuse,
                      light.specular, attenuation.cast<float>(), static_cast<float>(light.range),
                      cone.cast<float>()});
  }
  return result;
}

Eigen::Vector3f upIn(const View& view) {
  const Eigen::Vector3d up_C = view.X_WC.linear().transpose() * Eigen::Vector3d::UnitZ();
  return up_C.cast<float>();
}

void setLights(const ShaderProgram& program, const std::vector<world::Light>& lights,
               const std::vector<std::size_t>& chosen, const std::vector<ShadowProjection>& shadows,
               const View& view) {
  const std::vector<LightInView> all = lightsIn(view, lights);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const LightInView& light = all[chosen[i]];
    const std::string name = "lights[" + std::to_string(i) + "].";
    program.set(name + "position_C", light.position_C);
    program.set(name + "direction_C", light.direction_C);
    program.set(name + "intensity", light.intensity);
    program.set(name + "specular", light.specular);
    program.set(name + "attenuation", light.attenuation);
    program.set(name + "range", light.range);
    program.set(name + "cone", light.cone);
  }
  for (const ShadowProjection& shadow : shadows) {
    const std::string index = "[" + std::to_string(shadow.map) + "]";
    const Eigen::Matrix4d shadow_from_camera = shadow.shadow_from_world * view.X_WC.matrix();
    program.set("shadow_from_camera" + index, Eigen::Matrix4f(shadow_from_camera.cast<float>()));
    program.set("shadow_texel" + index, static_cast<float>(shadow.texel));
  }
}

}  // namespace synthetic_dataset::render

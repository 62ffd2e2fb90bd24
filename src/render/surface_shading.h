#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "render/lanes.h"
#include "render/light_setup.h"
#include "render/shadow_lookup.h"
#include "world/look.h"

namespace synthetic_dataset::render {

/// Surfaces at four points that are seen, in the camera's optical frame.
struct SurfaceLanes {
  Lanes3 position_C;
  Lanes3 face;    ///< its normal, towards the camera
  Lanes3 normal;  ///< as a normal map bends it
  Lanes3 base;    ///< linear colour
  Lanes reflectance;
  Lanes roughness;
  Lanes metalness;
  Lanes3 glow;
  Lanes is_lit;  ///< 0 where light leaves it as it is
};

/// How light makes surfaces seen, as lighting.glsl has it, which lights what one can see through:
/// Lambert diffuse, GGX specular (Walter et al. 2007, with Schlick's Fresnel and the
/// height-correlated visibility of Heitz 2014 in Hammon's approximation), hemispheric ambient
/// light. All lighting is linear.
class SurfaceShading {
 public:
  /// A light with its shadow, if it casts one.
  struct ShadedLight {
    LightInView light;
    std::optional<ShadowLookup> shadow;
  };

  /// What all surfaces of a picture have in common.
  struct Surroundings {
    std::vector<ShadedLight> lights;
    Eigen::Vector3f ambient;
    Eigen::Vector3f up_C;
    float exposure;
    std::optional<world::Fog> fog;
  };

  explicit SurfaceShading(const Surroundings& surroundings);

  /// What the camera sees of surfaces, as bright as a picture can be.
  [[nodiscard]] Lanes3 seen(const SurfaceLanes& surface) const;

 private:
  /// What the surface does with light, wherever that comes from.
  struct Response {
    Lanes3 to_eye;
    Lanes3 f0;
    Lanes3 matte;
    Lanes alpha;
    Lanes n_dot_v;
  };

  [[nodiscard]] Lanes3 lit(const SurfaceLanes& surface) const;
  [[nodiscard]] static Lanes3 sent(const ShadedLight& from, const SurfaceLanes& surface,
                                   const Response& response);
  [[nodiscard]] Lanes fogginess(const Lanes& distance) const;

  Surroundings surroundings_;
  Eigen::Vector3f fog_light_{0.0F, 0.0F, 0.0F};  ///< exposed
};

}  // namespace synthetic_dataset::render

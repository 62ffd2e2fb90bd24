#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "render/light/arriving_lights.h"
#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {

/// Surfaces at four visible points, in the camera's optical frame.
struct SurfaceLanes {
  Lanes3 position_C;
  Lanes3 face;    ///< its normal, towards the camera
  Lanes3 normal;  ///< as bent by a normal map
  Lanes3 base;    ///< linear colour
  Lanes reflectance;
  Lanes roughness;
  Lanes metalness;
  Lanes3 glow;
  Lanes ambient_visibility;  ///< the share of the ambient light that arrives
  Lanes is_lit;              ///< 0 where the surface is unlit
};

/// The share of gz-sim's ambient light that reaches surfaces facing downwards.
inline constexpr float kAmbientFromBelow = 0.55F;

/// The lighting model of gz-sim's worlds; lighting.glsl contains it for see-through surfaces.
/// Lambert diffuse, GGX specular (Walter et al. 2007, with Schlick's Fresnel and the
/// height-correlated visibility of Heitz 2014 in Hammon's approximation), hemispheric ambient
/// light. All lighting is linear.
class SurfaceShading {
 public:
  /// @param context  has to outlive this object
  explicit SurfaceShading(const LightingContext& context);

  /// The surfaces' light in the picture, at most 1.
  /// @param lights  the indices in the context of the lights that reach the surfaces
  [[nodiscard]] Lanes3 seen(const SurfaceLanes& surface,
                            const std::vector<std::size_t>& lights) const;

  [[nodiscard]] const ArrivingLights& lights() const { return lights_; }

 private:
  /// How the surface reflects any light.
  struct Response {
    Lanes3 to_eye;
    Lanes3 f0;
    Lanes3 matte;
    Lanes alpha;
    Lanes n_dot_v;
  };

  [[nodiscard]] Lanes3 ambient(const SurfaceLanes& surface, const Response& response) const;
  [[nodiscard]] Lanes3 imageBasedLight(const EnvironmentLight& environment,
                                       const SurfaceLanes& surface, const Response& response,
                                       const Lanes3& matte) const;
  [[nodiscard]] Lanes3 lit(const SurfaceLanes& surface,
                           const std::vector<std::size_t>& lights) const;
  [[nodiscard]] Lanes3 reflected(std::size_t light, const SurfaceLanes& surface,
                                 const Response& response) const;

  const LightingContext& context_;
  ArrivingLights lights_;
  Eigen::Vector3f fog_light_{0.0F, 0.0F, 0.0F};  ///< exposed
};

}  // namespace synthetic_dataset::render

#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "render/light/arriving_lights.h"
#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {

/// Gazebo Classic's surfaces at four visible points, in the camera's optical frame.
/// Colours are sRGB-encoded.
struct ClassicLanes {
  Lanes3 position_C;
  Lanes3 face;               ///< its normal, towards the camera
  Lanes3 normal;             ///< as bent by a normal map; for backs, that of their fronts
  Lanes3 albedo;             ///< the colour of its texture; white if it has none
  Lanes3 ambient;            ///< its colour under ambient light
  Lanes ambient_visibility;  ///< the share of the ambient light that arrives
  Lanes3 emissive;           ///< what it emits, regardless of lights
  Lanes3 diffuse;
  Lanes3 specular;
  Lanes shininess;  ///< Blinn-Phong's exponent; 0: no highlight
  Lanes3 glow;      ///< from an emissive texture
};

/// The lighting model of Gazebo Classic's worlds; lighting.glsl contains it for see-through
/// surfaces. OGRE 1 lights each pixel (RTShaderLib, SGXLib_PerPixelLighting.glsl):
///
///     (emissive + ambient x scene's ambient + sum of diffuse x light x n.l x fall-off) x picture
///         + sum of specular x light's specular x (n.h)^shininess x fall-off
///
/// where a light counts only on its side of the surface, and the highlight only with a shininess
/// above 0 (OgreShaderExPerPixelLighting.cpp). All numbers are sRGB-encoded, as in the files and in
/// the picture's pixels; the result is clamped to 1, or above it for short exposures.
class ClassicShading {
 public:
  /// @param context  has to outlive this object
  explicit ClassicShading(const LightingContext& context);

  /// The surfaces' colours in the picture, sRGB-encoded, before exposure.
  /// @param lights  the indices in the context of the lights that reach the surfaces
  [[nodiscard]] Lanes3 seen(const ClassicLanes& surface,
                            const std::vector<std::size_t>& lights) const;

  [[nodiscard]] const ArrivingLights& lights() const { return lights_; }

 private:
  struct Sums {
    Lanes3 diffuse;
    Lanes3 specular;
  };

  [[nodiscard]] Lanes3 ambientLight(const ClassicLanes& surface) const;
  void add(std::size_t light, const ClassicLanes& surface, Sums& sums) const;

  const LightingContext& context_;
  ArrivingLights lights_;
};

}  // namespace synthetic_dataset::render

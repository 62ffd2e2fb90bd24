#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "render/light/environment_light.h"
#include "render/light/light_setup.h"
#include "render/pixels/lanes.h"
#include "render/shadows/map_depths.h"
#include "render/shadows/shadow_lookup.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// What all surfaces of a picture have in common.
struct LightingContext {
  std::vector<LightInView> lights;
  std::vector<std::vector<CastShadow>> shadows;  ///< of each light: none, one, or a cube's six
  Eigen::Vector3f ambient;                       ///< linear; in Gazebo Classic's worlds encoded
  Eigen::Vector3f up_C;
  float exposure;
  std::optional<world::Fog> fog;
  world::Simulator simulator = world::Simulator::kGz;  ///< whose lighting model is used

  /// Replaces the ambient light; null for none.
  std::shared_ptr<const EnvironmentLight> environment = nullptr;
  Eigen::Matrix3f R_GC = Eigen::Matrix3f::Identity();  ///< for `environment`
};

/// Light and where it comes from.
struct Arriving {
  Lanes3 to_light;
  Lanes distance;  ///< [m]; 0 for directional lights
  Lanes falling;   ///< the share of the light's intensity that arrives, without shadows
};

/// Computes what arrives of a picture's lights at four points at once, for any lighting model.
class ArrivingLights {
 public:
  /// @param context  has to outlive this object
  explicit ArrivingLights(const LightingContext& context);

  /// The indices of all lights in the context.
  [[nodiscard]] std::vector<std::size_t> all() const;

  /// Finds the indices in the context of the lights that reach a box.
  /// @param low, high  the box's corners, in the camera's optical frame
  void reaching(const Eigen::Vector3f& low, const Eigen::Vector3f& high,
                std::vector<std::size_t>& lights) const;

  /// Whether there are so many lights that it is worth finding out which ones reach a place.
  [[nodiscard]] bool areMany() const;

  [[nodiscard]] Arriving at(std::size_t light, const Lanes3& position_C) const;

  /// The share of arriving light that the shadows let pass.
  /// @param face  the surface's normal, towards the camera
  /// @param faces  a mask: set where the surface faces the light
  [[nodiscard]] Lanes passing(std::size_t light, const Lanes3& position_C, const Lanes3& face,
                              const Arriving& coming, const Lanes& faces) const;

  /// The share of the fog in what is seen at a distance [m] from the camera. (OGRE uses the depth
  /// along the axis instead, so that its fog changes when a camera turns.)
  [[nodiscard]] Lanes fogginess(const Lanes& distance) const;

 private:
  const LightingContext& context_;
  std::list<MapDepths::Assembled> maps_;            ///< to which the lookups refer
  std::vector<std::vector<ShadowLookup>> lookups_;  ///< of each light
  std::vector<float> reaches_;                      ///< of each light [m]
};

}  // namespace synthetic_dataset::render

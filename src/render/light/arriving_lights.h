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
  std::vector<std::vector<CastShadow>> shadows;  ///< of each light: none, one, or those of a cube
  Eigen::Vector3f ambient;                       ///< linear; in Gazebo Classic's worlds encoded
  Eigen::Vector3f up_C;
  float exposure;
  std::optional<world::Fog> fog;
  world::Simulator simulator = world::Simulator::kGz;  ///< whose light it is

  /// In the place of the ambient light; null for none.
  std::shared_ptr<const EnvironmentLight> environment = nullptr;
  Eigen::Matrix3f R_GC = Eigen::Matrix3f::Identity();  ///< for it
};

/// Light and where it comes from.
struct Arriving {
  Lanes3 to_light;
  Lanes distance;  ///< [m]; 0 for directional lights
  Lanes falling;   ///< how much of the light's intensity arrives, shadows apart
};

/// What arrives of a picture's lights at four points at once, in whichever way surfaces answer.
class ArrivingLights {
 public:
  /// @param context  have to outlive this
  explicit ArrivingLights(const LightingContext& context);

  /// All lights, by their indices in the context.
  [[nodiscard]] std::vector<std::size_t> all() const;

  /// The lights, by their indices in the context, of which something arrives within a box.
  /// @param low, high  its corners, in the camera's optical frame
  void reaching(const Eigen::Vector3f& low, const Eigen::Vector3f& high,
                std::vector<std::size_t>& lights) const;

  /// Whether there are so many that it is worth while to ask which reach a place.
  [[nodiscard]] bool areMany() const;

  [[nodiscard]] Arriving at(std::size_t light, const Lanes3& position_C) const;

  /// How much of it the shadows let pass.
  /// @param face  the surface's normal, towards the camera
  /// @param faces  a mask: where the surface faces the light
  [[nodiscard]] Lanes passing(std::size_t light, const Lanes3& position_C, const Lanes3& face,
                              const Arriving& coming, const Lanes& faces) const;

  /// The share of the fog in what is seen at a distance [m] from the camera. (OGRE takes the depth
  /// along the axis instead, so that its fog changes where a camera turns.)
  [[nodiscard]] Lanes fogginess(const Lanes& distance) const;

 private:
  const LightingContext& context_;
  std::list<MapDepths::Assembled> maps_;            ///< which the lookups refer to
  std::vector<std::vector<ShadowLookup>> lookups_;  ///< of each light
  std::vector<float> reaches_;                      ///< of each light [m]
};

}  // namespace synthetic_dataset::render

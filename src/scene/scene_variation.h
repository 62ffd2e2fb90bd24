#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/scene_facts.h"
#include "randomize/appearance/entry_draws.h"
#include "randomize/appearance/look_sampler.h"
#include "render/renderer.h"
#include "render/sensor/sensor_effects.h"
#include "scene/camera_rig.h"
#include "scene/object_variants.h"
#include "scene/scene_options.h"
#include "world/world.h"

namespace synthetic_dataset::scene {

/// Makes each scene look different: light, paint, sensors, lenses, as `randomize` says.
class SceneVariation {
 public:
  /// @param variants  of each object
  /// @param world  has to outlive this
  /// @param diagnostics  receives what the user should know
  /// @throws ErrorList with the entries that have no meaning in this world
  SceneVariation(const SceneOptions& config, const std::vector<CameraRig>& cameras,
                 std::vector<ObjectVariants> variants, const world::World& world,
                 base::Diagnostics& diagnostics);

  /// Draws what the scenes of an instant look like, and applies it to the renderer and to the
  /// cameras' sensors and lenses.
  void vary(std::int64_t instant, render::Renderer& renderer, std::vector<CameraRig>& cameras);

  /// Draws which objects are present at an instant and which of their variants are active, before
  /// anything in its scenes is placed.
  /// @param world  that of the constructor
  void choose(std::int64_t instant, world::World& world);

  /// The current materials of surfaces (world::Look::materials).
  [[nodiscard]] const std::map<const world::Material*, world::Material>& materials() const {
    return materials_;
  }

  /// What was drawn last for a camera's scene.
  [[nodiscard]] std::vector<base::DrawFacts> draws(std::size_t camera) const;

 private:
  [[nodiscard]] std::vector<bool> choosePresent(randomize::EntryDraws& draws) const;
  [[nodiscard]] render::Weather weather(randomize::EntryDraws& draws) const;
  [[nodiscard]] render::LensDust dust(std::int64_t instant, const std::string& camera,
                                      std::vector<randomize::DrawnValue>& drawn) const;
  [[nodiscard]] render::SensorEffects varied(const render::SensorEffects& effects,
                                             randomize::EntryDraws& draws) const;

  randomize::Randomization config_;
  std::uint64_t seed_;
  bool is_placed_;                              ///< each scene is independent, rather than part of
                                                ///< a recording
  std::vector<render::SensorEffects> effects_;  ///< of the cameras, as they are set
  std::vector<CameraModel> models_;             ///< of the cameras, as they are calibrated
  std::optional<randomize::LookSampler> looks_;
  std::map<const world::Material*, world::Material> materials_;
  std::vector<ObjectOptions> objects_;                       ///< that are followed or placed
  std::vector<ObjectVariants> variants_;                     ///< of each object
  std::vector<randomize::DrawnValue> chosen_;                ///< of the instant: which objects are
                                                             ///< there
  std::vector<randomize::DrawnValue> shared_;                ///< of the instant: its look
  std::vector<std::vector<randomize::DrawnValue>> cameras_;  ///< of each camera
};

}  // namespace synthetic_dataset::scene

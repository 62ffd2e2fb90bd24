#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "randomize/appearance/background_sampler.h"
#include "randomize/appearance/entry_draws.h"
#include "randomize/appearance/randomize_options.h"
#include "randomize/appearance/texture_source.h"
#include "randomize/placement/surroundings.h"
#include "world/look.h"
#include "world/world.h"

namespace synthetic_dataset::randomize {

/// Lights and paints a world anew for each scene.
class LookSampler {
 public:
  /// @param world  has to outlive this
  /// @throws ErrorList naming the entries whose lights, model, link or visual the world does not
  ///     have, folders without pictures, and pictures that cannot be decoded
  LookSampler(const Randomization& config, const world::World& world);

  /// The look of a scene; what is drawn for it is added to the draws.
  /// @throws Error naming the entry, for a picture that cannot be decoded after all
  [[nodiscard]] world::Look sample(EntryDraws& draws);

 private:
  /// A light, and what is drawn of it.
  struct LightEntry {
    std::size_t light;  ///< index in the world's
    std::string name;   ///< "lights/sun"
    LightRandomization config;
    bool is_of_every = false;  ///< it has no group of its own
  };

  /// Surfaces that get the same material, and what is drawn of it.
  struct MaterialEntry {
    std::string name;  ///< "materials/rover_1/rover_1::base_link::hull"
    MaterialRandomization config;
    std::vector<const world::Surface*> surfaces;
    std::vector<bool> takes_texture;                  ///< of surfaces
    std::vector<Eigen::Vector2d> metres_per_texture;  ///< of surfaces, by metresPerTexture()
    TextureSource* textures = nullptr;                ///< one of textures_, where they are drawn
    std::string textures_entry;                       ///< "randomize/materials/rover_1/textures"
  };

  void findLights(const Randomization& config, base::Diagnostics& errors);
  void checkLightCount(base::Diagnostics& errors) const;
  void findSurfaces(const std::string& target, const MaterialRandomization& config,
                    base::Diagnostics& errors);
  void relightAll(EntryDraws& draws, world::Look& look);

  /// @return whether it is on
  [[nodiscard]] bool relight(const LightEntry& entry, EntryDraws& draws, world::Light& light);
  [[nodiscard]] Eigen::Vector3d freeShift(const Eigen::Vector3d& p_G,
                                          const Eigen::Vector3d& shift_G);
  void chooseLights(EntryDraws& draws, world::Look& look) const;
  void repaint(const MaterialEntry& entry, EntryDraws& draws, world::Look& look);

  const world::World& world_;
  Randomization config_;
  std::vector<LightEntry> lights_;
  std::optional<Surroundings> surroundings_;  ///< once a light that has a position is moved
  std::optional<BackgroundSampler> background_;
  std::vector<MaterialEntry> materials_;           ///< the more special ones later
  std::map<std::string, TextureSource> textures_;  ///< by where they are from
};

}  // namespace synthetic_dataset::randomize

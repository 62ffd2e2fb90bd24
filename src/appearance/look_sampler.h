#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "appearance/entry_draws.h"
#include "appearance/texture_source.h"
#include "config/randomization.h"
#include "world/look.h"
#include "world/world.h"

namespace synthetic_dataset::appearance {

/// Lights and paints a world anew for each scene.
class LookSampler {
 public:
  /// @param world  has to outlive this
  /// @throws ErrorList naming the entries whose light, model, link or visual the world does not
  ///     have, and folders without pictures
  LookSampler(const config::Randomization& config, const world::World& world);

  /// The look of a scene; what is drawn for it is added to the draws.
  [[nodiscard]] world::Look sample(EntryDraws& draws);

 private:
  /// A light, and what is drawn of it.
  struct LightEntry {
    std::size_t light;  ///< index in the world's
    std::string name;   ///< "lights/sun"
    config::LightRandomization config;
  };

  /// Surfaces that wear the same, and what is drawn of it.
  struct MaterialEntry {
    std::string name;  ///< "materials/rover_1/rover_1::base_link::hull"
    config::MaterialRandomization config;
    std::vector<const world::Surface*> surfaces;
    std::vector<bool> takes_texture;  ///< of surfaces
    std::size_t textures = 0;         ///< index in textures_
  };

  void findLights(const config::Randomization& config, std::vector<std::string>& errors);
  void findSurfaces(const std::string& target, const config::MaterialRandomization& config,
                    std::vector<std::string>& errors);
  void relight(const LightEntry& entry, EntryDraws& draws, world::Light& light) const;
  void repaint(const MaterialEntry& entry, EntryDraws& draws, world::Look& look);

  const world::World& world_;
  config::Randomization config_;
  std::vector<LightEntry> lights_;
  std::vector<MaterialEntry> materials_;  ///< the more special ones later
  std::vector<TextureSource> textures_;
};

}  // namespace synthetic_dataset::appearance

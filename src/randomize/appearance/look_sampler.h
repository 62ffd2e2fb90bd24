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
  /// @param world  must outlive this
  /// @throws ErrorList naming the entries whose light, model, link or visual does not exist in the
  ///     world, folders without pictures, and pictures that cannot be decoded
  LookSampler(const Randomization& config, const world::World& world);

  /// The look of a scene; everything drawn for it is recorded in `draws`.
  /// @throws Error naming the entry if a picture turns out not to be decodable
  [[nodiscard]] world::Look sample(EntryDraws& draws);

 private:
  /// A light, and how it is randomized.
  struct LightEntry {
    std::size_t light;  ///< index in the world's lights
    std::string name;   ///< "lights/sun"
    LightRandomization config;
    bool is_of_every = false;  ///< configured by the group `every`
  };

  /// Surfaces that receive the same material, and how it is randomized.
  struct MaterialEntry {
    std::string name;  ///< "materials/rover_1/rover_1::base_link::hull"
    MaterialRandomization config;
    std::vector<const world::Surface*> surfaces;
    std::vector<bool> takes_texture;                  ///< one per surface
    std::vector<Eigen::Vector2d> metres_per_texture;  ///< one per surface, from metresPerTexture()
    TextureSource* textures = nullptr;                ///< one of textures_, if textures are drawn
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
  std::optional<Surroundings> surroundings_;  ///< once a light with a position is moved
  std::optional<BackgroundSampler> background_;
  std::vector<MaterialEntry> materials_;           ///< the more specific ones later
  std::map<std::string, TextureSource> textures_;  ///< by their source
};

}  // namespace synthetic_dataset::randomize

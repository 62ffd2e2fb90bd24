#include "randomize/appearance/look_sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "base/diagnostics.h"
#include "base/image/picture_channels.h"
#include "randomize/appearance/texture_tiling.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"
#include "synthetic_dataset/value.h"
#include "world/material/material_conversions.h"

namespace synthetic_dataset::randomize {
namespace {

const char* const kObjects = "objects";
const char* const kWorld = "world";
const char* const kDistractors = "distractors";

/// The names that refer to a visual: its model's, its link's within that, and its own within that.
std::array<std::string, 3> namesOf(const world::LinkInstance& link, const world::Visual& visual) {
  const std::string link_name = link.model + "::" + link.link->name;
  return {link.model, link_name, link_name + "::" + visual.name};
}

bool isMeant(const std::string& target, const world::LinkInstance& link,
             const world::Visual& visual) {
  const bool is_distractor = link.role == world::Role::kDistractor;
  const bool is_object = link.object >= 0 && !is_distractor;
  if (target == kObjects) return is_object;
  if (target == kDistractors) return is_distractor;
  if (target == kWorld) return !is_object && !is_distractor;
  const auto names = namesOf(link, visual);
  return std::find(names.begin(), names.end(), target) != names.end();
}

/// Whether a target is a kind of thing. There may be none of it: an empty world is valid, too.
bool isKind(const std::string& target) {
  return target == kObjects || target == kWorld || target == kDistractors;
}

/// How specific a target is; more specific targets override the others.
std::ptrdiff_t rankOf(const std::string& target) {
  if (isKind(target)) return 0;
  return 1 + std::count(target.begin(), target.end(), ':');
}

std::vector<std::string> modelNames(const world::World& world) {
  std::set<std::string> names{kObjects, kWorld, kDistractors};
  for (const world::LinkInstance& link : world.links()) names.insert(link.model);
  return {names.begin(), names.end()};
}

/// A texture with holes or of glass is part of the thing's shape and must stay; without texture
/// coordinates none can be seen.
bool takesTexture(const world::Surface& surface) {
  const std::shared_ptr<const world::Texture>& texture = surface.material.texture;
  return !surface.mesh->texture_coordinates.empty() &&
         (!texture || base::isOpaque(texture->pixels));
}

/// Checks that the entry suits the light: a point light has a position, sunlight a direction. Not
/// called for `every`, where each light uses what applies to it.
void checkMeaning(const world::Light& light, const LightRandomization& config,
                  base::Diagnostics& errors) {
  const std::string parameter = "randomize/lights/" + light.name;
  const bool is_sun = light.type == world::LightType::kDirectional;
  if (is_sun && config.shift) {
    errors.error(parameter + "/shift",
                 "a directional light has no place; elevation and azimuth "
                 "turn it");
  }
  if (!is_sun && (config.elevation || config.azimuth)) {
    errors.error(parameter + "/elevation, azimuth",
                 "only directional lights are turned; shift "
                 "moves a light that has a position");
  }
}

void turnOff(world::Light& light) {
  light.diffuse.setZero();
  light.specular.setZero();
}

/// The direction in which light from an elevation and an azimuth [rad] shines.
Eigen::Vector3d shiningFrom(double elevation, double azimuth) {
  return -Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                          std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
}

}  // namespace

LookSampler::LookSampler(const Randomization& config, const world::World& world)
    : world_(world), config_(config) {
  base::Diagnostics errors;
  findLights(config, errors);
  checkLightCount(errors);
  errors.attempt([&] { background_.emplace(config.background); });
  std::vector<std::pair<std::ptrdiff_t, std::string>> targets;
  for (const auto& [target, material] : config.materials) {
    targets.emplace_back(rankOf(target), target);
  }
  std::sort(targets.begin(), targets.end());
  for (const auto& [rank, target] : targets) {
    findSurfaces(target, config.materials.at(target), errors);
  }
  errors.throwIfAny();
}

void LookSampler::findLights(const Randomization& config, base::Diagnostics& errors) {
  std::set<std::string> names;
  const std::vector<world::Light>& lights = world_.description().lights;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    names.insert(lights[i].name);
    auto entry = config.lights.find(lights[i].name);
    if (entry == config.lights.end()) entry = config.lights.find(kOthers);
    if (entry == config.lights.end()) continue;
    if (entry->first != kOthers) checkMeaning(lights[i], entry->second, errors);
    lights_.push_back({i, "lights/" + lights[i].name, entry->second, entry->first == kOthers});
  }
  for (const auto& [name, light] : config.lights) {
    if (name == kOthers || names.count(name) != 0) continue;
    errors.error("randomize/lights/" + name, "the world has no light of this name" +
                                                 didYouMean(name, {names.begin(), names.end()}));
  }
}

/// Accepts up to half above the number of lights: only the range's very end rounds up to more.
void LookSampler::checkLightCount(base::Diagnostics& errors) const {
  const std::size_t count = world_.description().lights.size();
  if (!config_.light_count) return;
  const double highest = config_.light_count->highest();
  if (highest <= static_cast<double>(count) + 0.5) return;
  errors.error("randomize/light_count",
               "found up to " + Value(highest).text() + "; the world has " + std::to_string(count) +
                   (count == 1 ? " light" : " lights") +
                   ", and it should be no more (a normal distribution ends at its `max`)");
}

void LookSampler::findSurfaces(const std::string& target, const MaterialRandomization& config,
                               base::Diagnostics& errors) {
  const std::string parameter = "randomize/materials/" + target;
  TextureSource* textures = nullptr;
  if (config.textures) {
    const auto make = [&] {
      base::namingPlace(parameter + "/textures", [&] {
        textures = &textures_.try_emplace(*config.textures, *config.textures).first->second;
      });
    };
    if (!errors.attempt(make)) return;
  }
  std::map<std::string, std::size_t> indices;  // in materials_, by name
  for (const world::LinkInstance& link : world_.links()) {
    for (const world::Visual& visual : link.link->visuals) {
      if (!isMeant(target, link, visual)) continue;
      const std::string what = config.for_each_visual ? namesOf(link, visual).back() : link.model;
      const std::string name = "materials/" + target + (what == target ? "" : "/" + what);
      const auto [index, is_new] = indices.try_emplace(name, materials_.size());
      if (is_new) {
        materials_.push_back({name, config, {}, {}, {}, textures, parameter + "/textures"});
      }
      for (const world::Surface& surface : visual.surfaces) {
        materials_[index->second].surfaces.push_back(&surface);
        materials_[index->second].takes_texture.push_back(takesTexture(surface));
        materials_[index->second].metres_per_texture.push_back(config.textures == "natural"
                                                                   ? metresPerTexture(*surface.mesh)
                                                                   : Eigen::Vector2d::Zero());
      }
    }
  }
  if (!indices.empty() || isKind(target)) return;
  errors.error(parameter,
               "the world has nothing visible of this name; it should be objects, "
               "distractors, world, a model, model::link or model::link::visual" +
                   didYouMean(target, modelNames(world_)));
}

world::Look LookSampler::sample(EntryDraws& draws) {
  world::Look look(world_.description());
  relightAll(draws, look);
  chooseLights(draws, look);
  if (const auto ambient = draws.vector("ambient", config_.ambient)) {
    look.ambient = ambient->cast<float>();
  }
  background_->sample(draws, look);
  for (const MaterialEntry& entry : materials_) repaint(entry, draws, look);
  return look;
}

/// Keeps one light on if `every` would turn off all of them.
void LookSampler::relightAll(EntryDraws& draws, world::Look& look) {
  std::vector<const LightEntry*> off;
  for (const LightEntry& entry : lights_) {
    if (!relight(entry, draws, look.lights[entry.light])) off.push_back(&entry);
  }
  const bool all_are_off = off.size() == look.lights.size();
  const auto kept = std::find_if(off.begin(), off.end(),
                                 [](const LightEntry* entry) { return entry->is_of_every; });
  for (const LightEntry* entry : off) {
    if (all_are_off && kept != off.end() && entry == *kept) {
      draws.replace(entry->name + "/present", 1.0);
    } else {
      turnOff(look.lights[entry->light]);
    }
  }
}

/// Shortens a light's shift where it would meet a surface, for example the ceiling it hangs from.
Eigen::Vector3d LookSampler::freeShift(const Eigen::Vector3d& p_G, const Eigen::Vector3d& shift_G) {
  constexpr double kClear = 0.05;  // from the surface [m]
  const double distance = shift_G.norm();
  if (distance < 1e-9) return shift_G;
  if (!surroundings_) surroundings_.emplace(world_);
  const auto hit = surroundings_->cast(p_G, shift_G, distance + kClear);
  if (!hit) return shift_G;
  return std::max(0.0, hit->distance - kClear) / distance * shift_G;
}

bool LookSampler::relight(const LightEntry& entry, EntryDraws& draws, world::Light& light) {
  const LightRandomization& config = entry.config;
  if (const auto colour = draws.vector(entry.name + "/colour", config.colour)) {
    light.diffuse = colour->cast<float>();
  }
  if (const auto intensity = draws.number(entry.name + "/intensity", config.intensity)) {
    light.diffuse *= static_cast<float>(*intensity);
    light.specular *= static_cast<float>(*intensity);
  }
  const bool is_on = !config.present || draws.happens(entry.name + "/present", *config.present);
  if (light.type != world::LightType::kDirectional) {
    const auto shift = draws.vector(entry.name + "/shift", config.shift);
    if (shift) light.X_WL.translation() += freeShift(light.X_WL.translation(), *shift);
    return is_on;
  }
  const auto elevation = draws.number(entry.name + "/elevation", config.elevation);
  const auto azimuth = draws.number(entry.name + "/azimuth", config.azimuth);
  if (!elevation && !azimuth) return is_on;
  const Eigen::Vector3d from = -(light.X_WL.linear() * light.direction_L).normalized();
  const Eigen::Vector3d direction =
      shiningFrom(elevation.value_or(std::asin(std::clamp(from.z(), -1.0, 1.0))),
                  azimuth.value_or(std::atan2(from.y(), from.x())));
  light.direction_L = light.X_WL.linear().transpose() * direction;
  return is_on;
}

/// Turns off random lights until the drawn number is left.
void LookSampler::chooseLights(EntryDraws& draws, world::Look& look) const {
  if (!config_.light_count) return;
  const std::string entry = "light_count";
  base::RandomSource random = draws.source(entry);
  const auto wanted =
      static_cast<std::size_t>(std::lround(config_.light_count->drawNumber(random)));
  const std::size_t on = std::min(wanted, look.lights.size());
  draws.note(entry, static_cast<double>(on));
  base::RandomSource shuffling = draws.source(entry + "/lights");
  const std::vector<std::size_t> order = shuffling.choice(look.lights.size(), look.lights.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    world::Light& light = look.lights[order[i]];
    draws.note("lights/" + light.name + "/present", i < on ? 1.0 : 0.0);
    if (i >= on) turnOff(light);
  }
}

void LookSampler::repaint(const MaterialEntry& entry, EntryDraws& draws, world::Look& look) {
  const MaterialRandomization& config = entry.config;
  const auto colour = draws.vector(entry.name + "/colour", config.colour);
  const auto tint = draws.vector(entry.name + "/tint", config.tint);
  const auto roughness = draws.number(entry.name + "/roughness", config.roughness);
  const auto metalness = draws.number(entry.name + "/metalness", config.metalness);
  std::shared_ptr<const world::Texture> texture;
  double tile = 1.0;  // the most that a natural texture covers: a wall is not one large brick [m]
  if (config.textures) {
    base::RandomSource random = draws.source(entry.name + "/textures");
    auto [name, drawn] =
        base::namingPlace(entry.textures_entry, [&] { return entry.textures->draw(random); });
    draws.note(entry.name + "/textures", name);
    texture = std::move(drawn);
    tile = std::exp2(random.uniform(0.0, 2.0));
  }
  for (std::size_t i = 0; i < entry.surfaces.size(); ++i) {
    const world::Material& given = entry.surfaces[i]->material;
    world::Material& varied = look.materials.try_emplace(&given, given).first->second;
    if (colour) varied.ambient = varied.diffuse.head<3>() = colour->cast<float>();
    if (tint) {
      varied.diffuse.head<3>().array() *= tint->cast<float>().array();
      varied.ambient.array() *= tint->cast<float>().array();
    }
    if (roughness) {
      varied.roughness = static_cast<float>(*roughness);
      varied.shininess = world::shininessOfRoughness(varied.roughness);
    }
    if (metalness) varied.metalness = static_cast<float>(*metalness);
    if (!texture || !entry.takes_texture[i]) continue;
    varied.texture = texture;
    if (entry.metres_per_texture[i].isZero()) continue;
    const Eigen::Array2f tiles = (entry.metres_per_texture[i] / tile).cast<float>();
    varied.texture_scale = varied.texture_scale.array().abs().max(tiles);
  }
}

}  // namespace synthetic_dataset::randomize

#include "world_setup.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "appearance/distractor_models.h"
#include "appearance/entry_errors.h"
#include "render/light_setup.h"
#include "seconds.h"

namespace synthetic_dataset {
namespace {

std::string modelNames(const world::Description& description) {
  std::string names;
  for (const world::Model& model : description.models) {
    names += (names.empty() ? "" : ", ") + model.name;
  }
  return names.empty() ? "none" : names;
}

/// Takes the model of this name out of the world.
std::optional<world::Model> takeModel(world::Description& description, const std::string& name) {
  auto& models = description.models;
  const auto found = std::find_if(models.begin(), models.end(),
                                  [&](const world::Model& model) { return model.name == name; });
  if (found == models.end()) return std::nullopt;
  world::Model model = std::move(*found);
  models.erase(found);
  return model;
}

/// An object that does not take part.
world::MovingObject nothingCalled(const std::string& name) {
  world::Model model;
  model.name = name;
  return {std::move(model), {}};
}

world::PhysicsOptions physicsOptions(const config::Config& config) {
  world::PhysicsOptions physics;
  physics.step = fromSeconds(config.physics.step);
  physics.contact_tolerance = config.physics.contact_tolerance;
  physics.drops_objects =
      config.isPlaced() && config.placement.mode == config::PlacementMode::kDrop;
  const auto& distractors = config.randomization.distractors;
  physics.drops_distractors = distractors && distractors->mode == config::DistractorMode::kDrop;
  physics.labels_distractors = distractors && distractors->label_class;
  return physics;
}

std::vector<world::Model> loadDistractors(const config::Config& config, WorldFiles& files) {
  const auto& distractors = config.randomization.distractors;
  if (!distractors) return {};
  const auto load = [&](const std::string& uri, const std::string& name) {
    return files.model(uri, name);
  };
  const std::string entry =
      std::string("randomize/distractors/") + (distractors->models.empty() ? "textures" : "models");
  return appearance::forEntry(entry, [&] {
    return appearance::makeDistractors(*distractors, static_cast<std::uint64_t>(config.seed), load);
  });
}

/// Loads the parts of a world one by one; what fails is noted.
class WorldBuilder {
 public:
  WorldBuilder(const config::Config& config, const motion::FrameMotion* frames, WorldFiles& files,
               ErrorCollector& errors)
      : config_(config), frames_(frames), files_(files), errors_(errors) {}

  WorldSetup build() {
    auto description = errors_.attempt([&] { return files_.world(); });
    if (!description) return std::move(setup_);
    model_names_ = modelNames(*description);
    setup_.sensors = description->cameras;
    for (const config::ObjectConfig& object : config_.objects) {
      if (!object.is_distractor) addObject(object, *description);
    }
    setup_.driven_links.resize(config_.objects.size());
    auto distractors = errors_.attempt([&] { return loadDistractors(config_, files_); });
    addTo(setup_.notes, files_.modelNotes());
    for (const auto& file : files_.found()) setup_.inputs.insert(file.string());
    const std::vector<world::CameraSensor>& on_objects = files_.modelCameras();
    setup_.sensors->insert(setup_.sensors->end(), on_objects.begin(), on_objects.end());
    if (!distractors || objects_.size() != config_.robotCount()) return std::move(setup_);
    auto world = errors_.attempt([&] {
      return std::make_unique<world::World>(std::move(*description), std::move(objects_),
                                            physicsOptions(config_), std::move(*distractors));
    });
    if (!world) return std::move(setup_);
    setup_.world = std::move(*world);
    addTo(setup_.notes, setup_.world->description().notes);
    addTo(setup_.notes, render::shadowNotes(setup_.world->description().lights));
    return std::move(setup_);
  }

 private:
  static void addTo(std::vector<std::string>& all, const std::vector<std::string>& more) {
    all.insert(all.end(), more.begin(), more.end());
  }

  void addObject(const config::ObjectConfig& object, world::Description& surroundings) {
    auto in_world = takeModel(surroundings, object.name);
    if (!object.takes_part) {
      objects_.push_back(nothingCalled(object.name));
      setup_.driven_links.emplace_back();
      return;
    }
    auto model = object.model
                     ? errors_.attempt([&] { return files_.model(*object.model, object.name); })
                     : std::move(in_world);
    if (model) {
      addModel(std::move(*model), object);
    } else if (!object.model) {
      errors_.add("robot_list: the world '" + config_.world.file + "' has no model '" +
                  object.name + "' (it has " + model_names_ +
                  "); add one to the world, or name a model file in " + object.name + "/model");
    }
  }

  void addModel(world::Model model, const config::ObjectConfig& object) {
    Articulation articulation;
    if (frames_ != nullptr) {
      auto made = errors_.attempt([&] { return articulate(std::move(model), object, *frames_); });
      if (!made) return;
      articulation = std::move(*made);
    } else {
      articulation.model = std::move(model);
    }
    std::vector<std::size_t> links;
    for (const DrivenLink& each : articulation.driven) links.push_back(each.link);
    objects_.emplace_back(std::move(articulation.model), std::move(links));
    setup_.driven_links.push_back(std::move(articulation.driven));
    addTo(setup_.remarks, articulation.remarks);
  }

  const config::Config& config_;
  const motion::FrameMotion* frames_;
  WorldFiles& files_;
  ErrorCollector& errors_;
  std::string model_names_;  ///< of the world, objects included
  std::vector<world::MovingObject> objects_;
  WorldSetup setup_;
};

}  // namespace

WorldSetup setUpWorld(const config::Config& config, const motion::FrameMotion* frames,
                      WorldFiles& files, ErrorCollector& errors) {
  return WorldBuilder(config, frames, files, errors).build();
}

}  // namespace synthetic_dataset

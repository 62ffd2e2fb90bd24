#include "run/setup/world_setup.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "base/diagnostics.h"
#include "base/seconds.h"
#include "randomize/appearance/distractor_models.h"
#include "randomize/appearance/room.h"
#include "render/light/light_setup.h"
#include "render/shadows/shadow_projection.h"
#include "world/mesh/mesh_loader.h"
#include "world/mesh/scaled_model.h"

namespace synthetic_dataset::run {
namespace {

std::string modelNames(const world::Description& description) {
  std::string names;
  for (const world::Model& model : description.models) {
    names += (names.empty() ? "" : ", ") + model.name;
  }
  return names.empty() ? "none" : names;
}

/// Removes the model of this name from the world and returns it.
std::optional<world::Model> takeModel(world::Description& description, const std::string& name) {
  auto& models = description.models;
  const auto found = std::find_if(models.begin(), models.end(),
                                  [&](const world::Model& model) { return model.name == name; });
  if (found == models.end()) return std::nullopt;
  world::Model model = std::move(*found);
  models.erase(found);
  return model;
}

/// An empty model for an object that does not take part.
world::MovingObject nothingCalled(const std::string& name) {
  world::Model model;
  model.name = name;
  return model;
}

std::vector<world::Model> loadDistractors(const config::Config& config, WorldFiles& files) {
  const auto& distractors = config.randomization.distractors;
  if (!distractors) return {};
  const auto load = [&](const std::string& uri, const std::string& name) {
    return files.model(uri, name);
  };
  const std::string entry =
      std::string("randomize/distractors/") + (distractors->models.empty() ? "textures" : "models");
  return base::namingPlace(entry, [&] {
    return randomize::makeDistractors(*distractors, static_cast<std::uint64_t>(config.seed), load);
  });
}

/// Loads the parts of a world one by one; failures are noted.
class WorldBuilder {
 public:
  WorldBuilder(const config::Config& config, const std::vector<scene::ObjectVariants>& variants,
               const motion::FrameSource* frames, WorldFiles& files, base::Diagnostics& diagnostics,
               const base::OnStage& on_stage)
      : config_(config),
        variants_(variants),
        frames_(frames),
        files_(files),
        diagnostics_(diagnostics),
        on_stage_(on_stage) {}

  WorldSetup build() {
    auto description = diagnostics_.attempt([&] { return files_.world(); });
    diagnostics_.add(base::Severity::kError, files_.refusals());
    if (!description) return std::move(setup_);
    model_names_ = modelNames(*description);
    addRoom(*description);
    setup_.sensors = description->cameras;
    setup_.lidars = description->lidars;
    simulator_ = description->simulator;
    on_stage_("reading the objects' models");
    for (std::size_t i = 0; i < config_.objects.size(); ++i) {
      setup_.driven_links.emplace_back();
      setup_.changes_O.emplace_back();
      const scene::ObjectOptions& object = config_.objects[i];
      if (!object.is_distractor) addObject(object, variants_[i].all(), *description);
    }
    auto distractors = diagnostics_.attempt([&] { return loadDistractors(config_, files_); });
    diagnostics_.add(base::Severity::kError, files_.refusals());
    addNotes(files_.modelNotes());
    diagnostics_.add(base::Severity::kWarning, files_.packageNotes());
    for (const auto& file : files_.found()) setup_.inputs.insert(file.string());
    for (const auto& file : files_.included()) setup_.included.insert(file.string());
    const std::vector<world::CameraSensor>& on_objects = files_.modelCameras();
    setup_.sensors->insert(setup_.sensors->end(), on_objects.begin(), on_objects.end());
    const std::vector<world::LidarSensor>& lidars = files_.modelLidars();
    setup_.lidars.insert(setup_.lidars.end(), lidars.begin(), lidars.end());
    if (!distractors || lacks_objects_) return std::move(setup_);
    on_stage_("making the world's bodies");
    auto world = diagnostics_.attempt([&] {
      return std::make_unique<world::World>(std::move(*description), std::move(objects_),
                                            config_.physics, std::move(*distractors));
    });
    if (!world) return std::move(setup_);
    setup_.world = std::move(*world);
    const world::Description& loaded = setup_.world->description();
    addNotes(loaded.notes);
    diagnostics_.add(base::Severity::kWarning,
                     render::lightNotes(loaded.lights, config_.rendering.light));
    return std::move(setup_);
  }

 private:
  /// Adds warnings about what files lack or may not have; for lines, which nobody would have seen,
  /// only a note.
  void addNotes(const std::vector<std::string>& notes) {
    for (const std::string& note : notes) {
      const bool is_trifle = note.find(world::kLinesNote) != std::string::npos;
      diagnostics_.add(is_trifle ? base::Severity::kNote : base::Severity::kWarning, {note});
    }
  }

  void addRoom(world::Description& description) {
    const auto& room = config_.randomization.room;
    if (!room) return;
    const auto same =
        std::find_if(description.models.begin(), description.models.end(),
                     [](const world::Model& model) { return model.name == randomize::kRoomName; });
    if (same == description.models.end()) {
      description.models.push_back(randomize::makeRoom(*room));
    } else {
      diagnostics_.error("randomize/room",
                         "the world '" + config_.world.file +
                             "' has a model 'room'; it should be a world without one");
    }
  }

  void addObject(const scene::ObjectOptions& object,
                 const std::vector<scene::ObjectVariant>& variants,
                 world::Description& surroundings) {
    const auto in_world = takeModel(surroundings, object.name);
    if (!object.takes_part) {
      objects_.push_back(nothingCalled(object.name));
      setup_.driven_links.back().emplace_back();
      return;
    }
    if (!in_world && !variants.front().model) {
      lacks_objects_ = true;
      diagnostics_.error(object.name + "/model",
                         "found none, and the world '" + config_.world.file + "' has no model '" +
                             object.name + "' (it has " + model_names_ +
                             "); it should name a model file, or the world should have that model");
      return;
    }
    if (object.stands) {
      addStanding(object, in_world, surroundings);
      return;
    }
    std::vector<world::MovingModel> moving;
    for (const scene::ObjectVariant& variant : variants) {
      if (variant.number > 0) on_stage_("making the varieties of '" + object.name + "'");
      const auto key = std::make_pair(variant.model, object.model_arguments);
      if (variant.model && broken_models_.count(key) != 0) continue;
      const bool is_loaded =
          !variant.model || diagnostics_.attempt([&] { (void)modelOf(variant, object); });
      if (!is_loaded) broken_models_.insert(key);
      if (is_loaded &&
          diagnostics_.attempt([&] { moving.push_back(makeVariant(variant, object, in_world)); })) {
        continue;
      }
      lacks_objects_ = true;
      if (!variant.model) return;
    }
    objects_.emplace_back(std::move(moving));
  }

  /// Adds an object that stands in the world: where the world has it, or at the pose set for it.
  void addStanding(const scene::ObjectOptions& object, std::optional<world::Model> in_world,
                   world::Description& surroundings) {
    std::optional<world::Model> model = std::move(in_world);
    if (object.model) {
      const auto loaded = diagnostics_.attempt([&] { return modelOf({object.model}, object); });
      if (!loaded) {
        lacks_objects_ = true;
        return;
      }
      model = *loaded;
    }
    if (object.X_GM) {
      model->X_WM = *object.X_GM;
      model->is_static = true;
    }
    setup_.standing_G.emplace(object.name, model->X_WM);
    setup_.changes_O.back().emplace_back();
    surroundings.models.push_back(std::move(*model));
    objects_.push_back(world::MovingObject::ofWorld(object.name));
  }

  const world::Model& modelOf(const scene::ObjectVariant& variant,
                              const scene::ObjectOptions& object) {
    const auto load = [&]() -> const world::Model& {
      return files_.model(*variant.model, object.name, object.model_arguments);
    };
    if (world::isModelText(*variant.model)) return load();  // its errors already name the setting
    const bool is_own = variant.model == object.model;
    return base::namingPlace((is_own ? "" : "randomize/objects/") + object.name + "/model", load);
  }

  world::MovingModel makeVariant(const scene::ObjectVariant& variant,
                                 const scene::ObjectOptions& object,
                                 const std::optional<world::Model>& in_world) {
    const world::Model& own = variant.model ? modelOf(variant, object) : *in_world;
    const randomize::VariedModel* varied = variantOf(own, variant, object);
    world::Model model = world::scaled(varied == nullptr ? own : varied->model, variant.scale);
    if (varied != nullptr) {
      model.name = own.name;
      model.X_WM = own.X_WM;
    }
    const Pose X_ML = own.links.empty() ? Pose::Identity() : own.links.front().X_ML;
    scene::Articulation articulation;
    if (frames_ != nullptr) {
      articulation = scene::articulate(std::move(model), object, *frames_);
    } else {
      articulation.model = std::move(model);
    }
    if (variant.scale != 1.0 && !articulation.driven.empty()) {
      throw Error("randomize/objects/" + object.name +
                  "/scale: links of this object follow TF, which keeps their distances the same "
                  "at any size; it should be without scale, or have link_frames that TF does not "
                  "know, such as 'rigid/{link}'");
    }
    if (variant.variety == randomize::Variety::kSameClass && variant.number == 1 &&
        !articulation.driven.empty()) {
      throw Error("randomize/objects/" + object.name +
                  "/variety: found same_class, and links of this object follow TF, which keeps "
                  "their distances the same in any shape; it should be same_object or none, "
                  "or have link_frames that TF does not know, such as 'rigid/{link}'");
    }
    noteChange(varied, X_ML, variant.scale, articulation.model);
    scene::DrivenLinks& driven =
        setup_.driven_links.back().emplace_back(std::move(articulation.driven));
    std::vector<std::size_t> links;
    for (const scene::DrivenLink& each : driven) links.push_back(each.link);
    const bool is_first = setup_.driven_links.back().size() == 1;
    if (is_first) diagnostics_.merge(articulation.diagnostics);
    return {std::move(articulation.model), std::move(links)};
  }

  /// One of the variants of a model; null: the unmodified model.
  const randomize::VariedModel* variantOf(const world::Model& own,
                                          const scene::ObjectVariant& variant,
                                          const scene::ObjectOptions& object) {
    if (variant.number == 0) return nullptr;
    return &files_.varieties().variantOf(own, simulator_, variant, object,
                                         static_cast<std::uint64_t>(config_.seed));
  }

  /// Records how points given in the object's frame follow a variant's shape.
  /// @param X_ML  pose of the first link before the model was moved to the object's frame
  /// @param moved  the model in the object's frame, scaled
  void noteChange(const randomize::VariedModel* varied, const Pose& X_ML, double scale,
                  const world::Model& moved) {
    scene::PointChange& change = setup_.changes_O.back().emplace_back();
    if (varied == nullptr || !varied->shape || moved.links.empty()) return;
    Pose X_OL = moved.links.front().X_ML;
    X_OL.translation() /= scale;
    const Pose X_OM = X_OL * X_ML.inverse();
    change = [X_OM, shape = *varied->shape](const Eigen::Vector3d& p_O) -> Eigen::Vector3d {
      return X_OM * shape.moved(X_OM.inverse() * p_O);
    };
  }

  const config::Config& config_;
  const std::vector<scene::ObjectVariants>& variants_;
  const motion::FrameSource* frames_;
  WorldFiles& files_;
  base::Diagnostics& diagnostics_;
  const base::OnStage& on_stage_;
  std::string model_names_;  ///< of the world, including objects
  std::vector<world::MovingObject> objects_;
  bool lacks_objects_ = false;
  /// Models with errors, so that other objects or sizes with the same model do not repeat them.
  std::set<std::pair<std::optional<std::string>, world::TemplateArguments>> broken_models_;
  world::Simulator simulator_ = world::Simulator::kClassic;
  WorldSetup setup_;
};

}  // namespace

WorldSetup setUpWorld(const config::Config& config,
                      const std::vector<scene::ObjectVariants>& variants,
                      const motion::FrameSource* frames, WorldFiles& files,
                      base::Diagnostics& diagnostics, const base::OnStage& on_stage) {
  return WorldBuilder(config, variants, frames, files, diagnostics, on_stage).build();
}

}  // namespace synthetic_dataset::run

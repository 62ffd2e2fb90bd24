#include "run_setup.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "appearance/distractor_models.h"
#include "dataset_description.h"
#include "error_collector.h"
#include "render/light_setup.h"
#include "ros_packages.h"
#include "run_record.h"
#include "scene_plan.h"
#include "seconds.h"
#include "synthetic_dataset/label_text.h"
#include "world/files/resource_finder.h"
#include "world/world_loader.h"

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

/// Builds a run part by part; what fails is noted, and the parts that need it are passed over.
class Builder {
 public:
  Builder(const Value& parameters, const std::vector<std::string>& plugin_xml_files)
      : parameters_(parameters), root_(parameters), plugin_xml_files_(plugin_xml_files) {}

  RunSetup build() {
    setup_.config = config::readConfig(root_);
    openRecording();
    loadWorld();
    setUpCameras();
    arrangeScenes();
    planRun();
    loadWriters();
    checkFrames();
    planSplits();
    noteSubtraction();
    const std::vector<std::string> unused = root_.unknownNames();
    throwErrors();
    setup_.defaults_taken = root_.defaultsTaken();
    describe(unused);
    return std::move(setup_);
  }

 private:
  [[nodiscard]] const config::Config& config() const { return setup_.config; }

  /// What the manifest tells of the run.
  /// @param unused  parameters that nobody read
  void describe(const std::vector<std::string>& unused) {
    output::RunDescription& run = setup_.description;
    run.settings = usedSettings(parameters_, config(), unused, root_.defaultValues());
    run.software = softwareVersions();
    const std::set<std::string> named = inputsNamedBy(config());
    inputs_.insert(named.begin(), named.end());
    run.inputs = describeInputs(inputs_);
    describeContents(dataset(), run);
    countLeftOut("scene left out: TF would be interpolated across more than max_tf_gap",
                 setup_.timeline.left_out_gap);
    countLeftOut("scene left out: a transform is not known at its time",
                 setup_.timeline.left_out_unknown);
  }

  void countLeftOut(const std::string& kind, std::int64_t count) {
    if (count > 0) setup_.description.warnings.push_back({kind, "", count});
  }

  [[nodiscard]] DatasetInfo dataset() const {
    static const std::vector<world::LinkInstance> kNoLinks;
    return describeDataset(config(), setup_.cameras,
                           setup_.world ? setup_.world->links() : kNoLinks, instantCount(),
                           splitPlan());
  }

  /// Runs a step that makes a part; none when it failed, with the errors noted.
  template <class Make>
  auto attempt(Make make) -> decltype(make()) {
    auto made = errors_.attempt(make);
    return made ? std::move(*made) : nullptr;
  }

  void openRecording() {
    if (isPlaced()) {
      setup_.frames = std::make_unique<motion::FrameMotion>(config().global_frame, nullptr);
      for (const config::ObjectConfig& each : config().objects) {
        if (setup_.frames->isPlaced(each.frame) || each.frame == config().global_frame) {
          errors_.add(each.name + "/frame: found '" + each.frame +
                      "', which is not its own; each object that is placed needs a frame of its "
                      "own");
        }
        placeSomewhere(each.frame);
      }
      return;
    }
    if (config().motion.bag_files.empty()) return;
    auto recording =
        attempt([&] { return std::make_unique<motion::BagMotion>(config().motion.bag_files); });
    if (!recording) return;
    addNotes(recording->notes());
    setup_.frames =
        std::make_unique<motion::FrameMotion>(config().global_frame, std::move(recording));
  }

  [[nodiscard]] bool isPlaced() const {
    return config().motion.source == config::MotionSource::kPlacement;
  }

  /// Frames that are placed scene by scene are known from the start.
  void placeSomewhere(const std::string& frame) { setup_.frames->place(frame, Pose::Identity()); }

  void loadWorld() {
    if (config().world.file.empty()) return;
    const world::ResourceFinder finder(config().world.model_folders, rosPackageFinder());
    world::LoadOptions options;
    options.default_near = config().cameras.front().near;
    options.default_far = config().cameras.front().far;
    if (config().world.on_missing_asset == config::OnMissingAsset::kWarn) {
      options.on_missing_asset = world::OnMissingAsset::kWarn;
    }
    world::WorldLoader loader(finder, options);
    description_ = errors_.attempt([&] { return loader.loadWorld(config().world.file); });
    if (!description_) return;
    world::Description surroundings = *description_;
    std::vector<world::MovingObject> objects;
    for (const config::ObjectConfig& object : config().objects) {
      auto model = objectModel(surroundings, object, loader);
      if (model) addObject(std::move(*model), object, objects);
    }
    auto distractors = errors_.attempt([&] { return loadDistractors(loader); });
    addNotes(loader.modelNotes());
    for (const auto& file : finder.found()) inputs_.insert(file.string());
    sensors_ = description_->cameras;
    const std::vector<world::CameraSensor>& on_objects = loader.modelCameras();
    sensors_.insert(sensors_.end(), on_objects.begin(), on_objects.end());
    if (objects.size() != config().objects.size()) return;
    world::PhysicsOptions physics;
    physics.step = fromSeconds(config().physics.step);
    physics.contact_tolerance = config().physics.contact_tolerance;
    physics.drops_objects = isPlaced() && config().placement.mode == config::PlacementMode::kDrop;
    if (!distractors) return;
    setup_.world = attempt([&] {
      return std::make_unique<world::World>(std::move(surroundings), std::move(objects), physics,
                                            std::move(*distractors));
    });
    if (!setup_.world) return;
    addNotes(setup_.world->description().notes);
    addNotes(render::shadowNotes(setup_.world->description().lights));
    setup_.shapes = attempt(
        [&] { return std::make_unique<ObjectShapes>(config().objects, setup_.world->links()); });
  }

  [[nodiscard]] std::vector<world::Model> loadDistractors(world::WorldLoader& loader) const {
    const auto& distractors = config().randomization.distractors;
    if (!distractors) return {};
    const auto load = [&](const std::string& uri, const std::string& name) {
      return loader.loadModel(uri, name);
    };
    const std::string group = "randomize/distractors";
    try {
      return appearance::makeDistractors(*distractors, static_cast<std::uint64_t>(config().seed),
                                         load);
    } catch (const ErrorList& list) {
      std::vector<std::string> messages;
      for (const std::string& each : list.messages())
        messages.push_back(group + "/models: " + each);
      throw ErrorList(std::move(messages));
    } catch (const Error& error) {
      throw Error(group + (distractors->models.empty() ? "/textures: " : "/models: ") +
                  error.what());
    }
  }

  /// Without a recording, which is an error already, no link is driven.
  void addObject(world::Model model, const config::ObjectConfig& object,
                 std::vector<world::MovingObject>& objects) {
    Articulation articulation;
    if (setup_.frames) {
      auto made =
          errors_.attempt([&] { return articulate(std::move(model), object, *setup_.frames); });
      if (!made) return;
      articulation = std::move(*made);
    } else {
      articulation.model = std::move(model);
    }
    std::vector<std::size_t> links;
    for (const DrivenLink& each : articulation.driven) links.push_back(each.link);
    objects.emplace_back(std::move(articulation.model), std::move(links));
    setup_.driven_links.push_back(std::move(articulation.driven));
    setup_.remarks.insert(setup_.remarks.end(), articulation.remarks.begin(),
                          articulation.remarks.end());
  }

  /// An object's own model, else the world's of its name, which leaves the world in any case.
  std::optional<world::Model> objectModel(world::Description& surroundings,
                                          const config::ObjectConfig& object,
                                          world::WorldLoader& loader) {
    auto in_world = takeModel(surroundings, object.name);
    if (object.model) {
      return errors_.attempt([&] { return loader.loadModel(*object.model, object.name); });
    }
    if (!in_world) {
      errors_.add("robot_list: the world '" + config().world.file + "' has no model '" +
                  object.name + "' (it has " + modelNames(*description_) +
                  "); add one to the world, or name a model file in " + object.name + "/model");
    }
    return in_world;
  }

  void setUpCameras() {
    static const std::vector<world::LinkInstance> kNoLinks;
    if (!setup_.frames || !description_) return;
    for (const config::CameraConfig& camera : config().cameras) {
      const bool two_sources = camera.info_file && camera.info_topic;
      const bool no_source = !camera.info_file && !camera.info_topic && !camera.sensor;
      if (two_sources || no_source) continue;  // told already
      auto rig = errors_.attempt([&] {
        return makeCameraRig(camera, config().motion.bag_files, sensors_,
                             setup_.world ? setup_.world->links() : kNoLinks, config().objects,
                             *setup_.frames);
      });
      if (!rig) continue;
      if (rig->sampled && isTaken(rig->frame, camera)) continue;
      if (rig->sampled) placeSomewhere(rig->frame);
      checkShutter(camera, *rig);
      noteBlindLens(camera, *rig);
      setup_.cameras.push_back(std::move(*rig));
    }
  }

  /// What is placed has a frame of its own: else one would be where the other is.
  bool isTaken(const std::string& frame, const config::CameraConfig& camera) {
    std::string owner = frame == config().global_frame ? "global_frame" : "";
    for (const config::ObjectConfig& object : config().objects) {
      if (object.frame == frame) owner = object.name;
    }
    for (const CameraRig& other : setup_.cameras) {
      if (other.frame == frame) owner = "the camera " + other.name;
    }
    if (owner.empty()) return false;
    errors_.add(camera.group + "/frame_id: found '" + frame + "', which is also the frame of " +
                owner + "; a camera that is put somewhere needs a frame of its own");
    return true;
  }

  /// Physics goes forward only, so a picture has to be exposed before the next one begins.
  void checkShutter(const config::CameraConfig& camera, const CameraRig& rig) {
    const Duration period = motion::periodOf(config().motion.rate);
    if (openTime(rig.shutter) <= period) return;
    errors_.add(camera.group + "/effects: found exposure_time + readout_time of " +
                fixed(toSeconds(openTime(rig.shutter)), 4) + " s; it should be at most the " +
                fixed(toSeconds(period), 4) + " s from one scene to the next (simulated_rate)");
  }

  void noteBlindLens(const config::CameraConfig& camera, const CameraRig& rig) {
    constexpr double kLittle = 0.25;  // a fisheye's circle in a wide image fills more than this
    const double share = seenShare(rig.model);
    if (share >= kLittle) return;
    addNotes({camera.group + ": its lens sees something in only " + fixed(100.0 * share, 0) +
              " % of the image; the rest is black (are the distortion's numbers right?)"});
  }

  [[nodiscard]] bool isCameraFrame(const std::string& frame) const {
    return std::any_of(setup_.cameras.begin(), setup_.cameras.end(),
                       [&](const CameraRig& camera) { return camera.frame == frame; });
  }

  void arrangeScenes() {
    if (!setup_.frames || !setup_.shapes || setup_.cameras.empty()) return;
    setup_.variation = attempt(
        [&] { return std::make_unique<SceneVariation>(config(), setup_.cameras, *setup_.world); });
    setup_.arranger = attempt([&] {
      return std::make_unique<SceneArranger>(config(), setup_.cameras, *setup_.shapes,
                                             *setup_.world, *setup_.frames);
    });
    if (!setup_.arranger) return;
    const std::vector<std::string>& remarks = setup_.arranger->remarks();
    setup_.remarks.insert(setup_.remarks.end(), remarks.begin(), remarks.end());
  }

  void planRun() {
    if (!setup_.frames || config().objects.empty()) return;
    auto timeline = errors_.attempt([&] {
      if (isPlaced()) return planUnrelatedScenes(config());
      return planScenes(*setup_.frames, config(), setup_.cameras, setup_.driven_links);
    });
    if (timeline) setup_.timeline = std::move(*timeline);
    const std::set<std::int64_t>& only = config().output.only_scenes;
    if (!timeline || only.empty() || *only.rbegin() < instantCount()) return;
    errors_.add("only_scenes: found " + std::to_string(*only.rbegin()) +
                "; this run's scenes are 0 to " + std::to_string(instantCount() - 1));
  }

  [[nodiscard]] std::int64_t instantCount() const {
    return static_cast<std::int64_t>(setup_.timeline.stamps.size());
  }

  [[nodiscard]] SplitPlan splitPlan() const {
    return {config().split, static_cast<std::uint64_t>(config().seed), instantCount()};
  }

  void loadWriters() {
    std::vector<writers::WriterChoice> choices;
    for (const config::WriterConfig& writer : config().writers) {
      choices.push_back({writer.name, writer.type, writer.output_folder, writer.parameters});
    }
    if (choices.empty()) return;
    setup_.writers = attempt([&] {
      return std::make_unique<writers::WriterHost>(choices, dataset(), plugin_xml_files_);
    });
  }

  /// Users of nn_data_collection's settings may not know that there are exact masks.
  void noteSubtraction() {
    const config::MaskConfig& masks = config().masks;
    if (masks.method == config::MaskMethod::kExact || masks.method_is_given) return;
    if (!setup_.writers || !setup_.writers->requirements().visible_masks) return;
    addNotes(
        {"masks are found by background subtraction since background_subtractor is set; "
         "masks/method: exact gives exact ones"});
  }

  /// When it is known how many scenes there are.
  void planSplits() {
    setup_.splits = std::make_unique<SplitPlan>(splitPlan());
    if (setup_.timeline.stamps.empty()) return;
    for (const SplitInfo& split : setup_.splits->splits(setup_.cameras.size())) {
      if (split.scene_count == 0) addNotes({"split/" + split.name + ": no scene falls into it"});
    }
  }

  /// The frames that writers ask for: unknown ones are errors, scenes without them are left out.
  void checkFrames() {
    if (!setup_.writers || !setup_.frames) return;
    for (const std::string& frame : setup_.writers->requirements().frames) {
      if (isCameraFrame(frame)) continue;
      if (setup_.frames->knowsFrame(frame)) {
        static_cast<void>(errors_.attempt([&] {
          leaveOutScenesWithout(frame, *setup_.frames, setup_.timeline);
          return true;
        }));
      } else {
        errors_.add("a writer asks for the frame '" + frame +
                    (isPlaced() ? "', which nothing that is placed has"
                                : "', which the recording does not have") +
                    setup_.frames->suggestFrame(frame));
      }
    }
  }

  void throwErrors() {
    ErrorCollector all;
    all.add(root_.errors());
    // Writers that could not be loaded have not read theirs: nothing can be said to be unknown.
    if (setup_.writers) all.add(config::unknownParameterErrors(root_));
    all.add(errors_.messages());
    all.throwIfAny();
  }

  void addNotes(const std::vector<std::string>& notes) {
    for (const std::string& note : notes) setup_.description.warnings.push_back({note});
  }

  const Value& parameters_;
  Parameters root_;
  const std::vector<std::string>& plugin_xml_files_;
  RunSetup setup_;
  std::optional<world::Description> description_;  ///< as the file has it, objects included
  std::vector<world::CameraSensor> sensors_;       ///< of the world and of the objects' models
  std::set<std::string> inputs_;                   ///< files of the world and of its models
  ErrorCollector errors_;
};

}  // namespace

RunSetup setUpRun(const Value& parameters, const std::vector<std::string>& plugin_xml_files) {
  return Builder(parameters, plugin_xml_files).build();
}

}  // namespace synthetic_dataset

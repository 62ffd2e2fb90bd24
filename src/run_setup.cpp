#include "run_setup.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <rospack/rospack.h>

#include "error_collector.h"
#include "world/resource_finder.h"
#include "world/sdf_loader.h"

namespace synthetic_dataset {
namespace {

Duration durationOf(double seconds) {
  return Duration(static_cast<std::int64_t>(std::llround(seconds * 1e9)));
}

/// Finds ROS packages as ros::package::getPath does, which would print an error about each that is
/// not there, and look for every one anew.
world::ResourceFinder::PackageFinder packageFinder() {
  auto packages = std::make_shared<rospack::Rospack>();
  packages->setQuiet(true);
  std::vector<std::string> search_path;
  if (packages->getSearchPathFromEnv(search_path)) packages->crawl(search_path, false);
  return [packages](const std::string& package) -> std::optional<std::string> {
    std::string folder;
    if (!packages->find(package, folder) || folder.empty()) return std::nullopt;
    return folder;
  };
}

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

motion::TimelineOptions timelineOptions(const config::MotionConfig& config) {
  motion::TimelineOptions options;
  options.period = motion::periodOf(config.rate);
  options.start_offset = durationOf(config.start_offset);
  if (config.duration) options.duration = durationOf(*config.duration);
  if (config.max_tf_gap) options.max_tf_gap = durationOf(*config.max_tf_gap);
  return options;
}

/// Builds a run part by part; what fails is noted, and the parts that need it are passed over.
class Builder {
 public:
  Builder(const Value& parameters, const std::vector<std::string>& plugin_xml_files)
      : root_(parameters), plugin_xml_files_(plugin_xml_files) {}

  RunSetup build() {
    setup_.config = config::readConfig(root_);
    openRecording();
    loadWorld();
    setUpCamera();
    planScenes();
    loadWriters();
    checkFrames();
    throwErrors();
    setup_.defaults_taken = root_.defaultsTaken();
    return std::move(setup_);
  }

 private:
  [[nodiscard]] const config::Config& config() const { return setup_.config; }

  /// Runs a step that makes a part; none when it failed, with the errors noted.
  template <class Make>
  auto attempt(Make make) -> decltype(make()) {
    auto made = errors_.attempt(make);
    return made ? std::move(*made) : nullptr;
  }

  void openRecording() {
    if (config().motion.bag_files.empty()) return;
    setup_.recording =
        attempt([&] { return std::make_unique<motion::BagMotion>(config().motion.bag_files); });
    if (setup_.recording) addNotes(setup_.recording->notes());
  }

  void loadWorld() {
    if (config().world.file.empty()) return;
    const world::ResourceFinder finder(config().world.model_folders, packageFinder());
    world::SdfLoadOptions options;
    options.default_near = config().camera.near;
    options.default_far = config().camera.far;
    world::SdfLoader loader(finder, options);
    description_ = errors_.attempt([&] { return loader.loadWorld(config().world.file); });
    if (!description_) return;
    world::Description surroundings = *description_;
    std::vector<world::Model> objects;
    for (const config::ObjectConfig& object : config().objects) {
      auto model = objectModel(surroundings, object, loader);
      if (model) objects.push_back(std::move(*model));
    }
    addNotes(loader.modelNotes());
    if (objects.size() != config().objects.size()) return;
    world::PhysicsOptions physics;
    physics.step = durationOf(config().physics.step);
    physics.contact_tolerance = config().physics.contact_tolerance;
    setup_.world = attempt([&] {
      return std::make_unique<world::World>(std::move(surroundings), std::move(objects), physics);
    });
    if (setup_.world) addNotes(setup_.world->description().notes);
  }

  /// An object's own model, else the world's of its name, which leaves the world in any case.
  std::optional<world::Model> objectModel(world::Description& surroundings,
                                          const config::ObjectConfig& object,
                                          world::SdfLoader& loader) {
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

  void setUpCamera() {
    if (!setup_.recording || !description_) return;
    if (!config().camera.info_file && !config().camera.sensor) return;  // told by the config
    setup_.camera = attempt([&] {
      return std::make_unique<CameraRig>(
          makeCameraRig(config().camera, *description_, *setup_.recording));
    });
  }

  void planScenes() {
    if (!setup_.recording || config().objects.empty()) return;
    std::vector<std::string> frames;
    for (const config::ObjectConfig& object : config().objects) frames.push_back(object.frame);
    if (setup_.camera && setup_.camera->followsRecording()) frames.push_back(setup_.camera->frame);
    auto timeline = errors_.attempt([&] {
      return setup_.recording->timeline(config().global_frame, frames,
                                        timelineOptions(config().motion));
    });
    if (timeline) setup_.timeline = std::move(*timeline);
  }

  [[nodiscard]] DatasetInfo datasetInfo() const {
    DatasetInfo info;
    for (const config::ObjectConfig& object : config().objects) {
      info.objects.push_back(
          {object.name, object.class_name, object.id, object.keypoints_O.size()});
    }
    info.scene_count = static_cast<std::int64_t>(setup_.timeline.stamps.size());
    info.global_frame = config().global_frame;
    if (setup_.camera) {
      const CameraModel& model = setup_.camera->model;
      info.cameras = {{"camera", config().camera.frame, model.width(), model.height()}};
    }
    return info;
  }

  void loadWriters() {
    std::vector<writers::WriterChoice> choices;
    for (const config::WriterConfig& writer : config().writers) {
      choices.push_back({writer.name, writer.type, writer.output_folder, writer.parameters});
    }
    if (choices.empty()) return;
    setup_.writers = attempt([&] {
      return std::make_unique<writers::WriterHost>(choices, datasetInfo(), plugin_xml_files_);
    });
  }

  /// The frames that writers ask for: unknown ones are errors, scenes without them are left out.
  void checkFrames() {
    if (!setup_.writers || !setup_.recording) return;
    for (const std::string& frame : setup_.writers->requirements().frames) {
      if (frame == config().camera.frame && setup_.camera) continue;
      if (setup_.recording->knowsFrame(frame)) {
        leaveOutScenesWithout(frame);
      } else {
        errors_.add("a writer asks for the frame '" + frame +
                    "', which the recording does not have" + setup_.recording->suggestFrame(frame));
      }
    }
  }

  void leaveOutScenesWithout(const std::string& frame) {
    auto& stamps = setup_.timeline.stamps;
    const std::size_t before = stamps.size();
    const auto unknown = [&](Stamp stamp) {
      return !setup_.recording->canTransform(config().global_frame, frame, stamp);
    };
    stamps.erase(std::remove_if(stamps.begin(), stamps.end(), unknown), stamps.end());
    setup_.timeline.left_out_unknown += static_cast<std::int64_t>(before - stamps.size());
    if (before > 0 && stamps.empty()) {
      errors_.add("a writer asks for the frame '" + frame +
                  "', which cannot be transformed into '" + config().global_frame +
                  "' at any scene");
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
    setup_.notes.insert(setup_.notes.end(), notes.begin(), notes.end());
  }

  Parameters root_;
  const std::vector<std::string>& plugin_xml_files_;
  RunSetup setup_;
  std::optional<world::Description> description_;  ///< as the file has it, objects included
  ErrorCollector errors_;
};

}  // namespace

RunSetup setUpRun(const Value& parameters, const std::vector<std::string>& plugin_xml_files) {
  return Builder(parameters, plugin_xml_files).build();
}

std::unique_ptr<output::DatasetStore> openOutput(const RunSetup& setup) {
  const config::OutputConfig& config = setup.config.output;
  output::StoreOptions options;
  options.folder = config.folder;
  options.if_exists = config.overwrite ? output::IfExists::kOverwrite : output::IfExists::kError;
  options.png_compression = config.png_compression;
  options.jpeg_quality = config.jpeg_quality;
  return std::make_unique<output::DatasetStore>(options, setup.writers->storeWriters());
}

}  // namespace synthetic_dataset

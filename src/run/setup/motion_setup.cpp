#include "run/setup/motion_setup.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "motion/placed_frames.h"
#include "run/setup/camera_setup.h"
#include "run/setup/input_cache.h"
#include "run/setup/open_times.h"
#include "run/setup/recorded_scenes.h"
#include "run/setup/recording_setup.h"
#include "run/setup/scene_plan.h"
#include "run/setup/setup_notes.h"
#include "run/setup/world_setup.h"
#include "scene/link_groups.h"

namespace synthetic_dataset::run {
namespace {

/// Null if the settings name none, which has already been reported as an error.
std::shared_ptr<const motion::FrameSource> makeSource(const config::Config& config,
                                                      InputCache& inputs) {
  switch (config.motion.source) {
    case motion::MotionSource::kPlacement:
      return std::make_shared<motion::PlacementMotion>(config.global_frame);
    case motion::MotionSource::kBag:
      if (config.motion.bag_files.empty()) return nullptr;
      return openRecording(config, inputs);
  }
  return nullptr;
}

/// Sets up a motion part by part; failures are noted, and parts that depend on them are skipped.
class MotionBuilder {
 public:
  MotionBuilder(config::MotionEntry entry, config::Config config, InputCache& inputs,
                const base::OnStage& on_stage)
      : inputs_(inputs), on_stage_(on_stage) {
    setup_.entry = std::move(entry);
    setup_.config = std::move(config);
    leaveOutOthers();
  }

  MotionSetup build() {
    openSource();
    loadWorld();
    setUpCameras(setup_, sensors_);
    setUpLidars();
    findPictures();
    arrangeScenes();
    planScenes();
    checkOpenTimes(setup_);
    checkRecorded();
    reportSource();
    return std::move(setup_);
  }

 private:
  [[nodiscard]] const config::Config& config() const { return setup_.config; }
  [[nodiscard]] base::Diagnostics& diagnostics() { return setup_.diagnostics; }

  /// Gives objects that do not take part frames that nothing else has.
  void leaveOutOthers() {
    const std::set<std::string>& named = setup_.entry.objects;
    if (named.empty()) return;
    for (scene::ObjectOptions& object : setup_.config.objects) {
      if (object.is_distractor) continue;
      object.takes_part = named.count(object.name) != 0;
      if (!object.takes_part) object.frame = "not in this motion: " + object.name;
    }
  }

  /// Runs a step that makes a part; null if it failed, with the errors noted.
  template <class Make>
  auto attempt(Make make) -> decltype(make()) {
    auto made = diagnostics().attempt(make);
    return made ? std::move(*made) : nullptr;
  }

  void openSource() {
    if (config().motion.source == motion::MotionSource::kBag) {
      const std::vector<std::string>& bags = config().motion.bag_files;
      on_stage_("reading the recording" + (bags.size() == 1 ? " '" + bags.front() + "'" : ""));
    }
    auto source = attempt([&] { return makeSource(config(), inputs_); });
    if (!source) return;
    setup_.frames = std::make_unique<motion::PlacedFrames>(std::move(source));
    if (config().isPlaced()) placeObjects();
    // Labelled distractors are also placed scene by scene, as is what physics moves.
    for (const scene::ObjectOptions& each : config().objects) {
      if (!each.takes_part) setup_.frames->place(each.frame, std::nullopt);
      if (each.takes_part && each.stands) placeSomewhere(each.frame);
    }
  }

  void placeObjects() {
    for (const scene::ObjectOptions& each : config().objects) {
      if (!each.takes_part || each.stands) continue;
      if (setup_.frames->isPlaced(each.frame) || each.frame == config().global_frame) {
        diagnostics().error(
            each.name + "/frame",
            "found '" + each.frame +
                "', which is not its own; each object that is placed needs a frame of its "
                "own");
      }
      placeSomewhere(each.frame);
    }
  }

  /// Data that was left out of the recording may explain what is missing.
  void reportSource() {
    if (!setup_.frames) return;
    base::Diagnostics notes;
    setup_.frames->report(usedFrames(), notes);
    const bool has_errors = diagnostics().hasErrors();
    for (const base::Diagnostic& note : notes.all()) {
      if (has_errors) diagnostics().error("bag_file", note.message());
    }
    diagnostics().merge(notes);
  }

  [[nodiscard]] std::vector<motion::FrameId> usedFrames() const {
    std::vector<motion::FrameId> frames;
    const auto add = [&](const std::string& name) {
      if (const auto frame = setup_.frames->find(name)) frames.push_back(*frame);
    };
    for (const scene::ObjectOptions& object : config().objects) add(object.frame);
    for (const scene::CameraRig& camera : setup_.cameras) {
      if (const std::string frame = camera.neededFrame(); !frame.empty()) add(frame);
    }
    for (const lidar::LidarRig& lidar : setup_.lidars) {
      if (lidar.followsFrame()) add(lidar.frame);
    }
    for (const std::vector<scene::DrivenLinks>& object : setup_.driven_links) {
      for (const scene::DrivenLinks& variant : object) {
        for (const scene::DrivenLink& link : variant) frames.push_back(link.frame);
      }
    }
    return frames;
  }

  /// Makes frames that are placed scene by scene known from the start.
  motion::FrameId placeSomewhere(const std::string& frame) {
    return setup_.frames->place(frame, Pose::Identity());
  }

  void loadWorld() {
    if (config().world.file.empty()) return;
    for (const scene::ObjectOptions& object : config().objects) {
      if (!diagnostics().attempt(
              [&] { setup_.variants.emplace_back(object, config().randomization); })) {
        setup_.variants.emplace_back(object, randomize::Randomization{});
      }
    }
    WorldSetup world =
        setUpWorld(config(), setup_.variants, setup_.frames.get(),
                   inputs_.worlds.filesFor(config().world), diagnostics(), on_stage_);
    sensors_ = std::move(world.sensors);
    around_lidars_.sensors = std::move(world.lidars);
    setup_.driven_links = std::move(world.driven_links);
    setup_.inputs = std::move(world.inputs);
    setup_.included = std::move(world.included);
    setup_.world = std::move(world.world);
    if (setup_.frames) {
      for (const scene::ObjectOptions& object : config().objects) {
        const auto X_GM = world.standing_G.find(object.name);
        if (X_GM != world.standing_G.end()) setup_.frames->place(object.frame, X_GM->second);
      }
    }
    if (!setup_.world) return;
    const std::vector<world::LinkInstance>& links = setup_.world->links();
    setup_.world_classes = scene::worldClassNumbers(config().world_classes, links, diagnostics());
    setup_.parts = scene::partNumbers(config().objects, links, diagnostics());
    noteSharedShapes();
    setup_.shapes = attempt([&] {
      return std::make_unique<scene::ObjectShapes>(config().objects, setup_.variants, *setup_.world,
                                                   world.changes_O);
    });
    noteStrangeSizes();
  }

  /// Warns of strange sizes, such as numbers in millimetres.
  void noteStrangeSizes() {
    if (!setup_.shapes) return;
    for (std::size_t i = 0; i < config().objects.size(); ++i) {
      const scene::ObjectOptions& object = config().objects[i];
      const bool varies = setup_.variants[i].all().size() > 1;  // and points with it
      if (object.takes_part && !object.is_distractor && !varies) {
        checkSizes(object, setup_.shapes->boxesAtRest(i).front(), diagnostics());
      }
    }
  }

  /// Notes points that were given for one model but apply to several.
  void noteSharedShapes() {
    for (std::size_t i = 0; i < config().objects.size(); ++i) {
      const scene::ObjectOptions& object = config().objects[i];
      const auto note = [&](const std::string& parameter, const std::string& instead) {
        diagnostics().warning(object.name + "/" + parameter,
                              "the same points are used for all models of randomize/objects; " +
                                  instead + " would find them on each");
      };
      if (!setup_.variants[i].hasSeveralModels()) continue;
      if (!object.bounding_shape_O.empty()) note("bounding_shape", "model_box");
      if (!object.keypoints_O.empty()) note("keypoints", "farthest_points");
    }
  }

  void setUpLidars() {
    if (!setup_.frames) return;
    for (const scene::ObjectOptions& object : config().objects) {
      if (object.takes_part) around_lidars_.object_frames.emplace(object.name, object.frame);
    }
    if (setup_.world) around_lidars_.links = setup_.world->links();
    for (lidar::LidarOptions& lidar : setup_.config.lidars) {
      if (lidar.sensor && !setup_.world) continue;  // reported already
      std::shared_ptr<const lidar::RecordedSweeps> recorded;
      if (lidar.recorded) recorded = findClouds(lidar);
      if (lidar.recorded && !recorded) continue;
      auto rig = diagnostics().attempt([&] {
        return lidar::makeLidarRig(lidar, around_lidars_, *setup_.frames, diagnostics(), recorded);
      });
      if (!rig) continue;
      if (lidar.frame.empty() && isTaken(*rig)) continue;
      lidar.frame = rig->frame;
      setup_.lidars.push_back(std::move(*rig));
    }
    const auto times = recordedTimes();
    if (times) setup_.config.motion.rate = motion::usualRate(*times).value_or(config().motion.rate);
  }

  [[nodiscard]] std::shared_ptr<const lidar::RecordedSweeps> findClouds(
      const lidar::LidarOptions& lidar) {
    if (config().isPlaced()) return nullptr;  // reported already
    on_stage_("looking through the recorded clouds of " + lidar.name);
    return attempt([&] {
      return std::make_shared<const lidar::RecordedSweeps>(lidar, config().motion.bag_files,
                                                           diagnostics());
    });
  }

  /// Whether the frame of a lidar's clouds belongs to a sensor already; frames named in the
  /// settings have been checked by the settings' reader.
  bool isTaken(const lidar::LidarRig& lidar) {
    if (!setup_.isSensorFrame(lidar.frame)) return false;
    diagnostics().error(lidar.group + "/frame_id",
                        "missing, and its clouds have the frame '" + lidar.frame +
                            "', which is also that of a camera or another lidar; each should have "
                            "its own");
    return true;
  }

  /// Scenes of recorded pictures are made at the pictures' times, whatever rate is set.
  void findPictures() {
    if (!config().isTwin() || !setup_.frames || setup_.cameras.size() != config().cameras.size()) {
      return;
    }
    on_stage_("looking through the recorded pictures");
    setup_.pictures = attempt([&] {
      return std::make_unique<scene::CameraPictures>(config().cameras, config().twin,
                                                     config().motion.bag_files, diagnostics());
    });
    if (!setup_.pictures) return;
    setup_.config.motion.rate = setup_.pictures->rate().value_or(config().motion.rate);
    findSurfaces();
  }

  void findSurfaces() {
    if (!config().twin.isMeasured()) {
      diagnostics().note(
          "twin",
          "neither depth_topic nor cloud_topic is set: nothing measures what stands in front "
          "of the objects, and all of their pixels are labelled as if only the world's models did");
      return;
    }
    on_stage_("looking through the measurements made with the pictures");
    setup_.surfaces = attempt([&] {
      return std::make_unique<scene::MeasuredSurfaces>(config().twin, config().motion.bag_files,
                                                       setup_.cameras, *setup_.pictures,
                                                       *setup_.frames);
    });
  }

  /// Checks the recorded pictures and clouds that the scenes use.
  void checkRecorded() {
    if (setup_.world && !setup_.timeline.stamps.empty()) {
      checkClouds(setup_.lidars, setup_.timeline.stamps, *setup_.world, diagnostics());
    }
    if (!setup_.pictures) return;
    diagnostics().add(base::Severity::kError,
                      setup_.pictures->problems(setup_.timeline.stamps, setup_.cameras));
    if (setup_.surfaces && !setup_.timeline.stamps.empty()) {
      setup_.surfaces->check(setup_.timeline.stamps, diagnostics());
    }
  }

  void arrangeScenes() {
    if (!setup_.frames || !setup_.shapes || setup_.cameras.empty()) return;
    on_stage_("arranging the scenes");
    setup_.variation = attempt([&] {
      return std::make_unique<scene::SceneVariation>(config(), setup_.cameras, setup_.variants,
                                                     *setup_.world, diagnostics());
    });
    setup_.arranger = attempt([&] {
      return std::make_unique<scene::SceneArranger>(config(), setup_.cameras, setup_.variants,
                                                    *setup_.shapes, *setup_.world, *setup_.frames,
                                                    diagnostics());
    });
  }

  void planScenes() {
    if (!setup_.frames || config().objects.empty()) return;
    if (config().isTwin() && !setup_.pictures) return;  // reported already
    if (config().hasRecordedTimes() && setup_.lidars.size() != config().lidars.size()) return;
    requireObjectsOfCameras(setup_);
    markAbsentInGaps(config(), *setup_.frames);
    auto timeline = diagnostics().attempt([&] {
      auto stamps = recordedTimes();
      if (stamps) stamps = scenesWithClouds(setup_.lidars, std::move(*stamps), diagnostics());
      return run::planScenes(*setup_.frames, config(), setup_.cameras, setup_.lidars,
                             setup_.driven_links, std::move(stamps));
    });
    if (!timeline) return;
    diagnostics().merge(timeline->diagnostics);
    setup_.timeline = std::move(*timeline);
  }

  /// The times of the recorded pictures, or clouds, for which scenes are made.
  [[nodiscard]] std::optional<std::vector<Stamp>> recordedTimes() const {
    if (setup_.pictures) return setup_.pictures->stamps();
    const lidar::LidarOptions* timing = config().timingLidar();
    if (timing == nullptr) return std::nullopt;
    for (const lidar::LidarRig& lidar : setup_.lidars) {
      if (lidar.name == timing->name) return lidar.recorded->stamps();
    }
    return std::nullopt;
  }

  InputCache& inputs_;
  const base::OnStage& on_stage_;
  MotionSetup setup_;
  std::optional<std::vector<world::CameraSensor>> sensors_;  ///< nothing: the world cannot be read
  lidar::LidarSurroundings around_lidars_;
};

}  // namespace

bool MotionSetup::isSensorFrame(const std::string& frame) const {
  return std::any_of(cameras.begin(), cameras.end(),
                     [&](const scene::CameraRig& camera) {
                       return camera.frame == frame || camera.optical_frame == frame;
                     }) ||
         std::any_of(lidars.begin(), lidars.end(),
                     [&](const lidar::LidarRig& lidar) { return lidar.frame == frame; });
}

MotionSetup setUpMotion(config::MotionEntry entry, config::Config config, InputCache& inputs,
                        const base::OnStage& on_stage) {
  return MotionBuilder(std::move(entry), std::move(config), inputs, on_stage).build();
}

}  // namespace synthetic_dataset::run

#include "run/live/live_run.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <optional>
#include <set>
#include <utility>

#include "base/stages.h"
#include "motion/bag/ros2_bag.h"
#include "run/live/glance.h"
#include "run/live/live_inputs.h"
#include "run/live/one_scene_sink.h"
#include "run/pictures/model_portrait.h"
#include "run/scene_loop.h"
#include "scene/placement_map.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::run {
namespace {

/// Measures elapsed time, and processor time over all processors.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  [[nodiscard]] double processorSeconds() const { return processorTime() - processor_start_; }

 private:
  [[nodiscard]] static double processorTime() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double processor_start_ = processorTime();
};

/// The index of the scene of a camera at an instant.
std::int64_t sceneOf(const RunSetup& run, std::int64_t instant, const std::string& camera) {
  if (instant < 0 || instant >= run.instantCount()) {
    throw Error("found instant " + std::to_string(instant) + "; the run has 0 to " +
                std::to_string(run.instantCount() - 1));
  }
  std::vector<std::string> names;
  for (const scene::CameraRig& each : run.motions.front().cameras) names.push_back(each.name);
  const auto named = camera.empty() ? names.begin() : std::find(names.begin(), names.end(), camera);
  if (named == names.end()) {
    throw Error("found no camera '" + camera + "'" + didYouMean(camera, names));
  }
  return instant * static_cast<std::int64_t>(names.size()) + (named - names.begin());
}

void makeScene(RunSetup& run, OneSceneSink& sink) {
  Reporter silent;
  SceneLoop(run, sink, silent).run();
}

std::size_t indexOf(const MotionSetup& motion, const std::string& object) {
  const auto& objects = motion.config.objects;
  const auto found = std::find_if(objects.begin(), objects.end(),
                                  [&](const auto& each) { return each.name == object; });
  return static_cast<std::size_t>(found - objects.begin());
}

}  // namespace

struct LiveRun::Impl {
  Impl(std::vector<std::string> plugin_xml_files, base::OnStage on_stage)
      : inputs(std::move(plugin_xml_files), std::move(on_stage)) {}

  LiveInputs inputs;
  std::unique_ptr<Glance> glance;          ///< only while nothing else draws
  std::optional<LiveRecording> recording;  ///< the last one requested
  std::string recording_frame;             ///< the frame of its paths
  FileStamps recording_files;
};

LiveRun::LiveRun(std::vector<std::string> plugin_xml_files, base::OnStage on_stage)
    : impl_(std::make_unique<Impl>(std::move(plugin_xml_files), std::move(on_stage))) {}

LiveRun::~LiveRun() = default;

void LiveRun::setSettings(const Value& settings) {
  impl_->glance.reset();
  impl_->inputs.setSettings(settings);
}

LiveSetup LiveRun::setup() {
  LiveSetup setup = impl_->inputs.described();
  if (const RunSetup* run = impl_->inputs.madeRun()) addEarlierRun(*run, setup);
  return setup;
}

LiveSetup LiveRun::check() {
  impl_->glance.reset();
  LiveInputs& inputs = impl_->inputs;
  if (!inputs.described().ready) return setup();
  WarningList warnings;
  try {
    RunCheck check = checkRun(inputs.takeUnusedRun(), warnings);
    inputs.describe(describeCheck(check, warnings.messages));
    inputs.giveBack(std::move(check.setup));
  } catch (const ErrorList& errors) {
    inputs.describe(describeErrors(errors));
  }
  return setup();
}

LiveScene LiveRun::scene(std::int64_t instant, const std::string& camera) {
  impl_->glance.reset();
  const Stopwatch watch;
  RunSetup& run = impl_->inputs.unusedRun();
  OneSceneSink sink(sceneOf(run, instant, camera));
  makeScene(run, sink);
  impl_->inputs.noteUsed();
  return {sink.scene().value(), watch.seconds(), watch.processorSeconds()};
}

cv::Mat LiveRun::glance(std::int64_t instant, const std::string& camera, const Pose& X_GC) {
  LiveInputs& inputs = impl_->inputs;
  (void)inputs.described();  // notices files that have changed
  if (!impl_->glance || !impl_->glance->canGoOn()) {
    impl_->glance.reset();
    impl_->glance = std::make_unique<Glance>(inputs.runOf(inputs.settings()));
  }
  const RunSetup& run = impl_->glance->run();
  const std::int64_t scene = sceneOf(run, instant, camera);
  const auto camera_count = static_cast<std::int64_t>(run.motions.front().cameras.size());
  return impl_->glance->picture(instant, static_cast<std::size_t>(scene % camera_count), X_GC);
}

std::vector<LiveDraw> LiveRun::draws(std::size_t count, std::int64_t instant,
                                     const std::string& camera) {
  impl_->glance.reset();
  LiveInputs& inputs = impl_->inputs;
  const std::int64_t index = sceneOf(inputs.unusedRun(), instant, camera);
  std::int64_t seed = inputs.unusedRun().config.seed;
  std::vector<LiveDraw> draws;
  for (; draws.size() < count; ++seed) {
    Value settings = inputs.settings();
    (*settings.as<Value::Map>())["seed"] = Value(seed);
    RunSetup run = inputs.runOf(settings);
    // With another seed there may be fewer scenes.
    if (index >= run.description.scene_count) break;
    OneSceneSink sink(index, {});
    makeScene(run, sink);
    draws.push_back({sink.scene().value().image, sink.draws()});
  }
  return draws;
}

const LiveRecording& LiveRun::recording() {
  const config::Config config = impl_->inputs.config();
  const std::vector<std::string>& bags = config.motion.bag_files;
  if (bags.empty()) throw ErrorList({"bag_file: missing; it names the recording"});
  const bool is_known = impl_->recording && impl_->recording->bags == bags &&
                        impl_->recording_frame == config.global_frame &&
                        impl_->recording_files.areCurrent();
  if (is_known) return *impl_->recording;
  FileStamps files;
  LiveRecording read{bags, motion::readContents(bags, config.global_frame)};
  for (const std::string& bag : bags) {
    for (const std::string& file : motion::filesOfBag(bag)) files.add(file);
  }
  impl_->recording = std::move(read);
  impl_->recording_frame = config.global_frame;
  impl_->recording_files = files;
  return *impl_->recording;
}

LiveWorld LiveRun::world() {
  impl_->glance.reset();
  config::Config config = impl_->inputs.config();
  if (config.world.file.empty()) throw ErrorList({"world: missing; it names the world's file"});
  WorldCache& worlds = impl_->inputs.cache().worlds;
  worlds.beginUse();
  LiveWorld live;
  live.file = config.world.file;
  try {
    live.description = worlds.filesFor(config.world).world();
  } catch (const ErrorList& errors) {
    live.missing = errors.messages();
    config.world.loading.on_missing_asset = world::OnMissingAsset::kWarn;
    live.description = worlds.filesFor(config.world).world();
  }
  std::set<std::string> objects;
  for (const scene::ObjectOptions& object : config.objects) objects.insert(object.name);
  live.bounds = visibleBounds(live.description);
  live.map = mapOf(live.description, objects);
  return live;
}

std::optional<LiveMap> LiveRun::placementMap() {
  const config::Config config = impl_->inputs.config();
  const bool has_map = config.placement.map_file || config.placement.map_topic;
  if (!config.isPlaced() || !has_map) return std::nullopt;
  base::Diagnostics said_by_the_run;
  return pictureOf(scene::readPlacementMap(config, said_by_the_run));
}

ObjectPortrait LiveRun::portrait(const std::string& object, const Viewpoint& viewpoint) {
  impl_->glance.reset();
  const MotionSetup& motion = impl_->inputs.motionWith(object);
  return portrayObject(motion, indexOf(motion, object), viewpoint);
}

std::optional<PickedPoint> LiveRun::pick(const std::string& object, const Viewpoint& viewpoint,
                                         const Eigen::Vector2d& pixel) {
  impl_->glance.reset();
  const MotionSetup& motion = impl_->inputs.motionWith(object);
  return pickPoint(motion, indexOf(motion, object), viewpoint, pixel);
}

}  // namespace synthetic_dataset::run

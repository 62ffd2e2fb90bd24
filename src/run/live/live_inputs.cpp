#include "run/live/live_inputs.h"

#include <algorithm>
#include <utility>

#include "base/json_text.h"
#include "config/motion_list.h"
#include "config/settings_file.h"
#include "run/world_history.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::run {
namespace {

using config::groupIn;

/// Whether the motion has a world and the object.
bool has(const MotionSetup& motion, const std::string& object) {
  const auto& objects = motion.config.objects;
  return motion.world &&
         std::any_of(objects.begin(), objects.end(), [&](const scene::ObjectOptions& each) {
           return each.name == object && each.takes_part;
         });
}

void eraseFrom(Value::Map* settings, const std::vector<std::string>& names) {
  if (settings == nullptr) return;
  for (const std::string& name : names) settings->erase(name);
}

/// Erases settings that do not affect where things are and when.
void eraseLooks(Value::Map& settings, const config::Config& config) {
  eraseFrom(&settings, {"labels", "masks", "background_subtractor", "writers", "image", "classes",
                        "world_classes", "output_folder", "if_exists"});
  eraseFrom(groupIn(settings, "camera"), {"pose"});
  if (Value::Map* cameras = groupIn(settings, "cameras")) {
    for (auto& [name, camera] : *cameras) eraseFrom(camera.as<Value::Map>(), {"pose"});
  }
  for (const scene::ObjectOptions& object : config.objects) {
    eraseFrom(groupIn(settings, object.name), {"class", "id", "keypoints", "bounding_shape"});
  }
  Value::Map* randomize = groupIn(settings, "randomize");
  eraseFrom(randomize, {"lights", "light_count", "ambient", "materials", "background"});
  if (randomize == nullptr || randomize->empty()) eraseFrom(&settings, {"seed", "randomize"});
}

/// Everything that determines how a motion's world moves; other settings are left out if they
/// change often.
std::string movementText(const MotionSetup& motion, const output::RunDescription& run) {
  Value settings = motion.entry.settings;
  if (auto* map = settings.as<Value::Map>()) eraseLooks(*map, motion.config);
  Value::List stamps;
  for (const Stamp stamp : motion.timeline.stamps) {
    stamps.emplace_back(static_cast<std::int64_t>(stamp.count()));
  }
  Value::List files;
  for (const auto& [file, input] : run.inputs) files.push_back(Value::List{file, input.digest});
  return base::jsonText(Value::List{settings, stamps, files});
}

}  // namespace

void LiveInputs::setSettings(const Value& settings) {
  settings_ = settings;
  forget();
}

void LiveInputs::forget() {
  described_.reset();
  errors_.reset();
  run_.reset();
  used_run_.reset();
  motion_.reset();
}

/// After an error, nothing counts as current: a missing file may appear at any time.
bool LiveInputs::areFilesCurrent() const {
  return !errors_ && files_.areCurrent() && cache_.worlds.areCurrent();
}

void LiveInputs::setUp() {
  files_ = FileStamps();
  try {
    run_ = std::make_unique<RunSetup>(runOf(settings_));
    for (const auto& [file, input] : run_->description.inputs) files_.add(file);
  } catch (const ErrorList& list) {
    errors_ = list;
  } catch (const Error& error) {
    errors_ = ErrorList({error.what()});
  }
}

const LiveSetup& LiveInputs::described() {
  if (described_ && !areFilesCurrent()) forget();
  if (described_) return *described_;
  setUp();
  described_ = errors_ ? describeErrors(*errors_) : describeSetup(*run_);
  return *described_;
}

RunSetup& LiveInputs::unusedRun() {
  (void)described();
  if (!errors_ && !run_) setUp();
  if (errors_) throw ErrorList(*errors_);
  return *run_;
}

void LiveInputs::noteUsed() { used_run_ = std::move(run_); }

RunSetup LiveInputs::takeUnusedRun() {
  RunSetup run = std::move(unusedRun());
  run_.reset();
  return run;
}

RunSetup LiveInputs::runOf(const Value& settings) {
  RunSetup run = setUpRun(settings, cache_, plugin_xml_files_, on_stage_);
  giveHistories(run);
  return run;
}

void LiveInputs::giveHistories(RunSetup& run) {
  constexpr std::size_t kMostKept = 8;
  if (worlds_read_ != cache_.worlds.readCount() || histories_.size() > kMostKept) {
    histories_.clear();
  }
  worlds_read_ = cache_.worlds.readCount();
  for (MotionSetup& motion : run.motions) {
    // With lidar sweeps, the history would keep the world's state a thousand times per second.
    if (!motion.config.lidars.empty()) continue;
    std::shared_ptr<WorldHistory>& history = histories_[movementText(motion, run.description)];
    if (!history) history = std::make_shared<WorldHistory>();
    motion.history = history;
  }
}

config::Config LiveInputs::config() const {
  return config::readConfig(Parameters(config::readMotions(settings_).entries.front().settings));
}

const MotionSetup* LiveInputs::madeMotionWith(const std::string& object) const {
  for (const auto* run : {run_.get(), used_run_.get()}) {
    if (run == nullptr) continue;
    for (const MotionSetup& motion : run->motions) {
      if (has(motion, object)) return &motion;
    }
  }
  return nullptr;
}

const MotionSetup& LiveInputs::motionWith(const std::string& object) {
  (void)described();
  if (madeRun() == nullptr && !errors_) setUp();  // after a failed check
  if (const MotionSetup* made = madeMotionWith(object)) return *made;
  if (!errors_) {
    throw ErrorList({"found no object '" + object + "'" + didYouMean(object, described_->objects)});
  }
  if (!motion_) {
    cache_.worlds.beginUse();
    const config::MotionList list = config::readMotions(settings_);
    motion_ = setUpMotion(list.entries.front(), config(), cache_, on_stage_);
  }
  if (has(*motion_, object)) return *motion_;
  throw ErrorList(*errors_);
}

}  // namespace synthetic_dataset::run

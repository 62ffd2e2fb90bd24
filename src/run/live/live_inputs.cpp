#include "run/live/live_inputs.h"

#include <algorithm>
#include <utility>

#include "config/motion_list.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::run {
namespace {

/// Whether the motion has the object and its world.
bool has(const MotionSetup& motion, const std::string& object) {
  const auto& objects = motion.config.objects;
  return motion.world &&
         std::any_of(objects.begin(), objects.end(), [&](const scene::ObjectOptions& each) {
           return each.name == object && each.takes_part;
         });
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

/// Where something is wrong, it may be a file that comes any time.
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

RunSetup LiveInputs::runOf(const Value& settings) {
  return setUpRun(settings, cache_, plugin_xml_files_);
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
  if (const MotionSetup* made = madeMotionWith(object)) return *made;
  if (!errors_) {
    throw ErrorList({"found no object '" + object + "'" + didYouMean(object, described_->objects)});
  }
  if (!motion_) {
    cache_.worlds.beginUse();
    const config::MotionList list = config::readMotions(settings_);
    motion_ = setUpMotion(list.entries.front(), config(), cache_, base::ignoreStage);
  }
  if (has(*motion_, object)) return *motion_;
  throw ErrorList(*errors_);
}

}  // namespace synthetic_dataset::run

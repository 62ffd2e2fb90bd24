#include "run/live/live_run.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <optional>
#include <utility>

#include "run/live/one_scene_sink.h"
#include "run/scene_loop.h"
#include "run/setup/input_cache.h"
#include "run/setup/run_setup.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::run {
namespace {

/// How long something took, by the clock and by all processors together.
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

}  // namespace

struct LiveRun::Impl {
  /// Sets the run up unless that is done.
  /// @throws ErrorList
  RunSetup& ready() {
    (void)described();
    if (errors) throw ErrorList(*errors);
    if (!run) run = std::make_unique<RunSetup>(setUpRun(settings, inputs, plugin_xml_files));
    return *run;
  }

  const LiveSetup& described() {
    if (live) return *live;
    try {
      run = std::make_unique<RunSetup>(setUpRun(settings, inputs, plugin_xml_files));
      live = describeSetup(*run);
    } catch (const ErrorList& list) {
      errors = list;
      live = describeErrors(list);
    } catch (const Error& error) {
      errors = ErrorList({error.what()});
      live = describeErrors(*errors);
    }
    return *live;
  }

  std::size_t cameraCalled(const std::string& name) {
    const std::vector<std::string>& cameras = described().cameras;
    if (name.empty()) return 0;
    const auto found = std::find(cameras.begin(), cameras.end(), name);
    if (found == cameras.end()) {
      throw Error("found no camera '" + name + "'" + didYouMean(name, cameras));
    }
    return static_cast<std::size_t>(found - cameras.begin());
  }

  std::vector<std::string> plugin_xml_files;
  InputCache inputs;
  Value settings;
  std::optional<LiveSetup> live;    ///< of the settings
  std::optional<ErrorList> errors;  ///< of the settings
  std::unique_ptr<RunSetup> run;    ///< of the settings, if no scene was made of it yet
};

LiveRun::LiveRun(std::vector<std::string> plugin_xml_files) : impl_(std::make_unique<Impl>()) {
  impl_->plugin_xml_files = std::move(plugin_xml_files);
}

LiveRun::~LiveRun() = default;

void LiveRun::setSettings(const Value& settings) {
  impl_->settings = settings;
  impl_->live.reset();
  impl_->errors.reset();
  impl_->run.reset();
}

const LiveSetup& LiveRun::setup() { return impl_->described(); }

LiveScene LiveRun::scene(std::int64_t instant, const std::string& camera) {
  const Stopwatch watch;
  RunSetup& run = impl_->ready();
  const std::int64_t count = run.instantCount();
  if (instant < 0 || instant >= count) {
    throw Error("found instant " + std::to_string(instant) + "; the run has 0 to " +
                std::to_string(count - 1));
  }
  const auto cameras = static_cast<std::int64_t>(run.config.cameras.size());
  const auto number = static_cast<std::int64_t>(impl_->cameraCalled(camera));
  OneSceneSink sink(instant * cameras + number);
  Reporter silent;
  SceneLoop(run, sink, silent).run();
  impl_->run.reset();  // its world has moved on
  if (!sink.scene())
    throw Error("the scene is left out: its alignment is below twin/min_alignment");
  return {*sink.scene(), watch.seconds(), watch.processorSeconds()};
}

}  // namespace synthetic_dataset::run

#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/stages.h"
#include "config/config.h"
#include "run/live/live_setup.h"
#include "run/setup/file_stamps.h"
#include "run/setup/input_cache.h"
#include "run/setup/run_setup.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// The settings of a LiveRun and what was made of them so far; anew when they or files change.
class LiveInputs {
 public:
  LiveInputs(std::vector<std::string> plugin_xml_files, base::OnStage on_stage)
      : plugin_xml_files_(std::move(plugin_xml_files)),
        on_stage_(std::move(on_stage)),
        cache_(on_stage_) {}

  void setSettings(const Value& settings);
  [[nodiscard]] const Value& settings() const { return settings_; }

  /// What the settings amount to.
  [[nodiscard]] const LiveSetup& described();

  /// The same with what a check has found, until the settings change.
  void describe(LiveSetup checked) { described_ = std::move(checked); }

  /// A run that has made no scene yet: the caller may have it make one.
  /// @throws ErrorList with what keeps it from beginning
  [[nodiscard]] RunSetup& unusedRun();

  /// After scenes were made of the unused run, which is for looking at from now on.
  void noteUsed();

  /// The unused run, for good. @throws ErrorList as unusedRun
  [[nodiscard]] RunSetup takeUnusedRun();

  /// A run that was taken and has made scenes, for looking at.
  void giveBack(RunSetup used_run) { used_run_ = std::make_unique<RunSetup>(std::move(used_run)); }

  /// A run of these settings that is only looked at; null where there is none.
  [[nodiscard]] const RunSetup* madeRun() const { return run_ ? run_.get() : used_run_.get(); }

  /// A run of other settings that read much of the same.
  /// @throws ErrorList as setUpRun
  [[nodiscard]] RunSetup runOf(const Value& settings);

  /// The settings of the first motion, as far as they are right.
  [[nodiscard]] config::Config config() const;

  /// A motion with a world in which the object takes part.
  /// @throws ErrorList where there is none, with what is wrong
  [[nodiscard]] const MotionSetup& motionWith(const std::string& object);

  [[nodiscard]] InputCache& cache() { return cache_; }

 private:
  void forget();
  [[nodiscard]] bool areFilesCurrent() const;
  void setUp();
  void giveHistories(RunSetup& run);
  [[nodiscard]] const MotionSetup* madeMotionWith(const std::string& object) const;

  std::vector<std::string> plugin_xml_files_;
  base::OnStage on_stage_;
  Value settings_;
  InputCache cache_;

  std::optional<LiveSetup> described_;
  std::optional<ErrorList> errors_;
  std::unique_ptr<RunSetup> run_;       ///< has made no scene yet
  std::unique_ptr<RunSetup> used_run_;  ///< has
  std::optional<MotionSetup> motion_;   ///< where there is no run
  FileStamps files_;                    ///< of the run's

  /// By all that decides how a motion's world moves, of worlds that were read so often.
  std::map<std::string, std::shared_ptr<WorldHistory>> histories_;
  std::int64_t worlds_read_ = 0;
};

}  // namespace synthetic_dataset::run

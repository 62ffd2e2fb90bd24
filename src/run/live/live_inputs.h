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

/// The settings of a LiveRun and what has been made from them so far; made anew when settings or
/// files change.
class LiveInputs {
 public:
  LiveInputs(std::vector<std::string> plugin_xml_files, base::OnStage on_stage)
      : plugin_xml_files_(std::move(plugin_xml_files)),
        on_stage_(std::move(on_stage)),
        cache_(on_stage_) {}

  void setSettings(const Value& settings);
  [[nodiscard]] const Value& settings() const { return settings_; }

  /// Describes the run that results from the settings.
  [[nodiscard]] const LiveSetup& described();

  /// Replaces the description by that of a check, until the settings change.
  void describe(LiveSetup checked) { described_ = std::move(checked); }

  /// A run that has made no scene yet: the caller may have it make one.
  /// @throws ErrorList with what keeps it from beginning
  [[nodiscard]] RunSetup& unusedRun();

  /// Call after the unused run has made scenes; from then on it may only be looked at.
  void noteUsed();

  /// Hands over the unused run. @throws ErrorList as unusedRun
  [[nodiscard]] RunSetup takeUnusedRun();

  /// Takes back a run that has made scenes, to be looked at.
  void giveBack(RunSetup used_run) { used_run_ = std::make_unique<RunSetup>(std::move(used_run)); }

  /// A run with these settings, only to be looked at; null if there is none.
  [[nodiscard]] const RunSetup* madeRun() const { return run_ ? run_.get() : used_run_.get(); }

  /// A run with other settings that shares most of its inputs.
  /// @throws ErrorList as setUpRun
  [[nodiscard]] RunSetup runOf(const Value& settings);

  /// The settings of the first motion, as far as they are valid.
  [[nodiscard]] config::Config config() const;

  /// A motion in whose world the object takes part.
  /// @throws ErrorList if there is none, with what is wrong
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
  std::optional<MotionSetup> motion_;   ///< set if there is no run
  FileStamps files_;                    ///< read by the run

  /// By everything that determines how a motion's world moves; valid as long as no further world is
  /// read (`worlds_read_`).
  std::map<std::string, std::shared_ptr<WorldHistory>> histories_;
  std::int64_t worlds_read_ = 0;
};

}  // namespace synthetic_dataset::run

#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "run/live/live_scene.h"
#include "run/live/live_setup.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// A run whose settings change while it is looked at: what it would make, at once. What is shown is
/// what the run makes, pixel by pixel; nothing is written.
///
/// Call everything from the thread that made it: OpenGL belongs to that. What a call throws leaves
/// it as it was.
class LiveRun {
 public:
  /// @param plugin_xml_files  as setUpRun
  explicit LiveRun(std::vector<std::string> plugin_xml_files = {});
  ~LiveRun();
  LiveRun(const LiveRun&) = delete;
  LiveRun& operator=(const LiveRun&) = delete;

  /// From now on. Reads nothing: that is done when something is asked for.
  /// @param settings  as setUpRun has them
  void setSettings(const Value& settings);

  /// What the settings amount to now, and what is wrong with them.
  [[nodiscard]] const LiveSetup& setup();

  /// One of the run's scenes.
  /// @param instant  from 0
  /// @param camera  its name; empty: the first one
  /// @throws ErrorList with what keeps the run from beginning
  /// @throws Error where there is no such instant or camera, or the scene cannot be made
  [[nodiscard]] LiveScene scene(std::int64_t instant, const std::string& camera = "");

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::run

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <opencv2/core/mat.hpp>

#include "base/stages.h"
#include "run/live/live_recording.h"
#include "run/live/live_scene.h"
#include "run/live/live_setup.h"
#include "run/live/live_world.h"
#include "run/live/object_portrait.h"
#include "synthetic_dataset/pose.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// A run whose settings change while it is looked at: what it would make, at once. What is shown is
/// what the run makes, pixel by pixel; nothing is written.
///
/// What was read for earlier settings is kept for as long as its files have the same size and time
/// (InputCache).
///
/// Call everything from the thread that made it: OpenGL belongs to that. What a call throws leaves
/// it as it was. Each call notices files that have changed.
class LiveRun {
 public:
  /// @param plugin_xml_files, on_stage  as setUpRun
  explicit LiveRun(std::vector<std::string> plugin_xml_files = {},
                   base::OnStage on_stage = base::ignoreStage);
  ~LiveRun();
  LiveRun(const LiveRun&) = delete;
  LiveRun& operator=(const LiveRun&) = delete;

  /// From now on. Reads nothing: that is done when something is asked for.
  /// @param settings  as setUpRun has them
  void setSettings(const Value& settings);

  /// What the settings amount to now, and what is wrong with them; with what a check has found,
  /// if there was one of the same settings.
  [[nodiscard]] LiveSetup setup();

  /// Checks the run thoroughly, as the tool `check` does: makes some nine of its scenes, which
  /// takes seconds.
  LiveSetup check();

  /// One of the run's scenes.
  /// @param instant  from 0
  /// @param camera  its name; empty: the first one
  /// @throws ErrorList with what keeps the run from beginning
  /// @throws Error where there is no such instant or camera, or the scene cannot be made
  [[nodiscard]] LiveScene scene(std::int64_t instant, const std::string& camera = "");

  /// A coarse picture of one of the run's scenes with its camera somewhere else, in a fraction of
  /// the time: to be looked at while the camera is moved (Glance).
  /// @throws Error as scene, and where the run's pictures are recorded ones
  [[nodiscard]] cv::Mat glance(std::int64_t instant, const std::string& camera, const Pose& X_GC);

  /// Pictures of one instant with one seed after another, the run's own first.
  /// @throws Error as scene
  [[nodiscard]] std::vector<LiveDraw> draws(std::size_t count, std::int64_t instant = 0,
                                            const std::string& camera = "");

  /// Reads the first motion's bags, whatever else is wrong with the settings.
  /// @throws ErrorList with what is wrong with the bags
  [[nodiscard]] const LiveRecording& recording();

  /// The settings' world, whatever else is wrong with the settings; of several motions the first.
  /// @throws ErrorList where there is none or it cannot be read at all
  [[nodiscard]] LiveWorld world();

  /// The occupancy map on whose free places objects are put; nothing where the settings name none.
  /// @throws Error with what is wrong with it
  [[nodiscard]] std::optional<LiveMap> placementMap();

  /// A portrait of an object's model, and what a click on it means. Both need the object, its model
  /// and its frame alone to be right.
  /// @param object  its name
  /// @throws ErrorList with what is wrong with it
  [[nodiscard]] ObjectPortrait portrait(const std::string& object, const Viewpoint& viewpoint);

  /// @param pixel  of a portrait from the same viewpoint; centres have whole coordinates
  [[nodiscard]] std::optional<PickedPoint> pick(const std::string& object,
                                                const Viewpoint& viewpoint,
                                                const Eigen::Vector2d& pixel);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::run

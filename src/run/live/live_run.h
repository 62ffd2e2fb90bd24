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

/// An interactive view of a run whose settings change: shows immediately what the run would make,
/// identical pixel by pixel; nothing is written.
///
/// Inputs read for earlier settings are kept as long as their files have the same size and
/// modification time (InputCache).
///
/// Call everything from the thread that constructed it, which owns the OpenGL context. A call that
/// throws leaves it unchanged. Each call notices files that have changed.
class LiveRun {
 public:
  /// @param plugin_xml_files, on_stage  as setUpRun
  explicit LiveRun(std::vector<std::string> plugin_xml_files = {},
                   base::OnStage on_stage = base::ignoreStage);
  ~LiveRun();
  LiveRun(const LiveRun&) = delete;
  LiveRun& operator=(const LiveRun&) = delete;

  /// Takes effect immediately, but reads nothing until something is asked for.
  /// @param settings  in the form used by setUpRun
  void setSettings(const Value& settings);

  /// Describes the run that results from the current settings, and what is wrong with them;
  /// includes the findings of a check of the same settings, if there was one.
  [[nodiscard]] LiveSetup setup();

  /// Checks the run thoroughly, as the tool `check` does: makes about nine of its scenes, which
  /// takes seconds.
  LiveSetup check();

  /// One of the run's scenes.
  /// @param instant  from 0
  /// @param camera  its name; if empty, the first one
  /// @throws ErrorList with whatever prevents the run from starting
  /// @throws Error if there is no such instant or camera, or the scene cannot be made
  [[nodiscard]] LiveScene scene(std::int64_t instant, const std::string& camera = "");

  /// A coarse picture of one of the run's scenes with its camera at another pose, in a fraction of
  /// the time, for display while the camera is being moved (Glance).
  /// @throws Error as scene, and if the run's pictures are recorded ones
  [[nodiscard]] cv::Mat glance(std::int64_t instant, const std::string& camera, const Pose& X_GC);

  /// Pictures of one instant with different seeds, the run's own seed first.
  /// @throws Error as scene
  [[nodiscard]] std::vector<LiveDraw> draws(std::size_t count, std::int64_t instant = 0,
                                            const std::string& camera = "");

  /// Reads the first motion's bags, regardless of any other errors in the settings.
  /// @throws ErrorList with what is wrong with the bags
  [[nodiscard]] const LiveRecording& recording();

  /// The settings' world (with several motions, the first one's), regardless of any other errors in
  /// the settings.
  /// @throws ErrorList if there is none or it cannot be read at all
  [[nodiscard]] LiveWorld world();

  /// The occupancy map on whose free space objects are placed; nothing if the settings name none.
  /// @throws Error with what is wrong with it
  [[nodiscard]] std::optional<LiveMap> placementMap();

  /// A portrait of an object's model; `pick` tells what a click on it hits. Both only need the
  /// object, its model and its frame to be valid.
  /// @param object  its name
  /// @throws ErrorList with what is wrong with it
  [[nodiscard]] ObjectPortrait portrait(const std::string& object, const Viewpoint& viewpoint);

  /// @param pixel  of a portrait from the same viewpoint; pixel centres have integer coordinates
  [[nodiscard]] std::optional<PickedPoint> pick(const std::string& object,
                                                const Viewpoint& viewpoint,
                                                const Eigen::Vector2d& pixel);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::run

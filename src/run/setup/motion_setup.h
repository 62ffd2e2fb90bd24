#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/stages.h"
#include "config/config.h"
#include "config/motion_list.h"
#include "lidar/lidar_rig.h"
#include "motion/placed_frames.h"
#include "scene/articulation.h"
#include "scene/camera_pictures.h"
#include "scene/camera_rig.h"
#include "scene/measured/measured_surfaces.h"
#include "scene/object_shapes.h"
#include "scene/object_variants.h"
#include "scene/scene_arranger.h"
#include "scene/scene_variation.h"
#include "world/world.h"

namespace synthetic_dataset::run {

class InputCache;
class WorldHistory;

/// Everything that the scenes of one of a run's motions are made from: where things move, in which
/// world, seen by which cameras, and when.
struct MotionSetup {
  config::MotionEntry entry;
  config::Config config;  ///< all settings that apply to it
  std::unique_ptr<motion::PlacedFrames> frames;
  motion::Timeline timeline;
  std::int64_t first_instant = 0;               ///< index in the run of its timeline's first time
  std::vector<scene::ObjectVariants> variants;  ///< of each object
  std::unique_ptr<world::World> world;
  std::shared_ptr<WorldHistory> history;  ///< of one that moves identically; read and extended
  std::vector<scene::CameraRig> cameras;
  std::vector<lidar::LidarRig> lidars;
  std::unique_ptr<scene::CameraPictures> pictures;    ///< recorded ones shown in scenes, if any
  std::unique_ptr<scene::MeasuredSurfaces> surfaces;  ///< recorded with the pictures, if any
  std::vector<std::vector<scene::DrivenLinks>> driven_links;  ///< of each object's variants
  std::vector<std::uint16_t> world_classes;     ///< values of the world's links in maps
  std::vector<std::uint16_t> parts;             ///< values of the world's links in maps
  std::unique_ptr<scene::ObjectShapes> shapes;  ///< of the objects
  std::unique_ptr<scene::SceneArranger> arranger;
  std::unique_ptr<scene::SceneVariation> variation;

  std::set<std::string> inputs;    ///< files of the world and its models
  std::set<std::string> included;  ///< further files that describe them: model.sdf, ...
  base::Diagnostics diagnostics;   ///< whatever depends on something wrong is missing

  /// How many instants it contributes to the run.
  [[nodiscard]] std::int64_t instantCount() const {
    return static_cast<std::int64_t>(timeline.stamps.size());
  }

  /// Whether a camera or lidar has this frame, which the source of motion then need not provide.
  [[nodiscard]] bool isSensorFrame(const std::string& frame) const;
};

/// Reads the recording, the world and the cameras, and determines the times of all scenes. Writes
/// nothing.
/// @param config  of the entry's settings
/// @param inputs  already read for other motions of the run, or for an earlier run
/// @param on_stage  called at the start of a step that may take long
[[nodiscard]] MotionSetup setUpMotion(config::MotionEntry entry, config::Config config,
                                      InputCache& inputs, const base::OnStage& on_stage);

}  // namespace synthetic_dataset::run

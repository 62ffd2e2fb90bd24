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

/// What the scenes of one of a run's motions are made of: where things go, in which world, seen by
/// which cameras, and when.
struct MotionSetup {
  config::MotionEntry entry;
  config::Config config;  ///< all settings that hold for it
  std::unique_ptr<motion::PlacedFrames> frames;
  motion::Timeline timeline;
  std::int64_t first_instant = 0;               ///< in the run, of its timeline's first time
  std::vector<scene::ObjectVariants> variants;  ///< of each object
  std::unique_ptr<world::World> world;
  std::shared_ptr<WorldHistory> history;  ///< of one that moves alike, to be read and added to
  std::vector<scene::CameraRig> cameras;
  std::vector<lidar::LidarRig> lidars;
  std::unique_ptr<scene::CameraPictures> pictures;    ///< recorded ones that scenes have, if any
  std::unique_ptr<scene::MeasuredSurfaces> surfaces;  ///< recorded with the pictures, if any
  std::vector<std::vector<scene::DrivenLinks>> driven_links;  ///< of each object's variants
  std::vector<std::uint16_t> world_classes;     ///< of the world's links, their values in maps
  std::vector<std::uint16_t> parts;             ///< of the world's links, their values in maps
  std::unique_ptr<scene::ObjectShapes> shapes;  ///< of the objects
  std::unique_ptr<scene::SceneArranger> arranger;
  std::unique_ptr<scene::SceneVariation> variation;

  std::set<std::string> inputs;    ///< files of the world and of its models
  std::set<std::string> included;  ///< others that these are described in: model.sdf, ...
  base::Diagnostics diagnostics;   ///< where something is wrong, what needs it is not there

  /// How many times it gives to the run.
  [[nodiscard]] std::int64_t instantCount() const {
    return static_cast<std::int64_t>(timeline.stamps.size());
  }

  /// Whether a camera or lidar has this frame: the source of motion need not have it then.
  [[nodiscard]] bool isSensorFrame(const std::string& frame) const;
};

/// Reads the recording, the world and the cameras, and finds the times of all scenes. Writes
/// nothing.
/// @param config  of the entry's settings
/// @param inputs  that were read for other motions of the run, or an earlier one
/// @param on_stage  called when a step begins that may take long
[[nodiscard]] MotionSetup setUpMotion(config::MotionEntry entry, config::Config config,
                                      InputCache& inputs, const base::OnStage& on_stage);

}  // namespace synthetic_dataset::run

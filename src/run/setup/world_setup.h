#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/stages.h"
#include "config/config.h"
#include "motion/frame_source.h"
#include "run/setup/world_files.h"
#include "scene/articulation.h"
#include "scene/object_shapes.h"
#include "scene/object_variants.h"
#include "world/world.h"

namespace synthetic_dataset::run {

/// A motion's world and what was learnt from its files.
struct WorldSetup {
  std::unique_ptr<world::World> world;                        ///< null if something is wrong
  std::vector<std::vector<scene::DrivenLinks>> driven_links;  ///< of each object's variants
  std::vector<std::vector<scene::PointChange>> changes_O;     ///< of each object's variants

  /// X_GM of objects that stand in the world at its start, by name.
  std::map<std::string, Pose> standing_G;

  /// The sensors of the world and of the objects' models; nothing if the world cannot be read.
  std::optional<std::vector<world::CameraSensor>> sensors;
  std::vector<world::LidarSensor> lidars;

  std::set<std::string> inputs;    ///< files found by URI or path
  std::set<std::string> included;  ///< other files read: models' descriptions, ...
};

/// Loads the world, the objects' models and the distractors. An object's model is that of its
/// variant or, failing that, the world's model of the same name, which is removed from the world
/// unless the object stands in it; an object that does not take part has nothing that could be seen
/// or touched.
/// @param variants  of each object
/// @param frames  tells which links follow frames of their own; null, which has already been
///     reported as an error: no link is driven
/// @param files  of the world named by config
/// @param diagnostics  receives everything that is wrong, was left out or replaced, or may be worth
///     knowing
[[nodiscard]] WorldSetup setUpWorld(const config::Config& config,
                                    const std::vector<scene::ObjectVariants>& variants,
                                    const motion::FrameSource* frames, WorldFiles& files,
                                    base::Diagnostics& diagnostics, const base::OnStage& on_stage);

}  // namespace synthetic_dataset::run

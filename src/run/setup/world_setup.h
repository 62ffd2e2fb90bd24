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

/// A motion's world, and what was learnt from its files.
struct WorldSetup {
  std::unique_ptr<world::World> world;                        ///< nothing where something is wrong
  std::vector<std::vector<scene::DrivenLinks>> driven_links;  ///< of each object's variants
  std::vector<std::vector<scene::PointChange>> changes_O;     ///< of each object's variants

  /// X_GM of objects that stand in the world at its start, by name.
  std::map<std::string, Pose> standing_G;

  /// The sensors of the world and of the objects' models; nothing where the world cannot be read.
  std::optional<std::vector<world::CameraSensor>> sensors;
  std::vector<world::LidarSensor> lidars;

  std::set<std::string> inputs;    ///< the files that were found by what names them
  std::set<std::string> included;  ///< others that were read: models' descriptions, ...
};

/// Loads the world, the objects' models and the distractors. An object's model is that of its
/// variant, else the world's of its name, which leaves the world unless the object stands in it;
/// one that does not take part is there as nothing that could be seen or touched.
/// @param variants  of each object
/// @param frames  which links follow frames of their own; none, which is an error already: no link
///     is driven
/// @param files  of the world that config names
/// @param diagnostics  takes all that is wrong, was left out or replaced, or may be good to know
[[nodiscard]] WorldSetup setUpWorld(const config::Config& config,
                                    const std::vector<scene::ObjectVariants>& variants,
                                    const motion::FrameSource* frames, WorldFiles& files,
                                    base::Diagnostics& diagnostics, const base::OnStage& on_stage);

}  // namespace synthetic_dataset::run

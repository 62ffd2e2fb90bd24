#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "motion/placed_frames.h"
#include "randomize/placement/camera_sampler.h"
#include "randomize/placement/distractor_placer.h"
#include "randomize/placement/scene_placer.h"
#include "randomize/placement/surroundings.h"
#include "scene/camera_rig.h"
#include "scene/object_shapes.h"
#include "scene/object_variants.h"
#include "scene/scene_options.h"
#include "world/world.h"

namespace synthetic_dataset::scene {

/// Puts what is put somewhere at random, scene by scene: objects, where there is no recording to
/// follow, and cameras.
class SceneArranger {
 public:
  /// Lets the props come to rest where objects are placed among them.
  /// @param variants  of each object
  /// @param shapes, world, frames  have to outlive this
  /// @param diagnostics  takes what the user may like to know
  /// @throws ErrorList with all that keeps objects and cameras from being placed
  SceneArranger(const SceneOptions& config, const std::vector<CameraRig>& cameras,
                const std::vector<ObjectVariants>& variants, const ObjectShapes& shapes,
                world::World& world, motion::PlacedFrames& frames, base::Diagnostics& diagnostics);

  /// Whether no scene has to do with the one before.
  [[nodiscard]] bool standsAlone() const { return placer_.has_value(); }

  /// Puts the objects of a time's scenes, if that is done here: the world starts anew then.
  void placeObjects(std::int64_t instant);

  /// Puts the frames of objects that physics moves to where the world has them now.
  void followProps();

  /// Puts the distractors of a time's scenes, as the world stands.
  void placeDistractors(std::int64_t instant, Stamp stamp);

  /// The numbers of the distractors that were placed last; nothing where there are none at all.
  [[nodiscard]] const std::optional<std::vector<int>>& distractors() const {
    return distractors_there_;
  }

  /// Puts the cameras of a time's scenes that are put at random, as the world stands.
  /// @return what the user should know of it
  [[nodiscard]] std::vector<base::Warning> placeCameras(std::int64_t instant, Stamp stamp);

 private:
  struct SampledCamera {
    motion::FrameId frame;
    std::string group;  ///< of its settings, for messages
    randomize::CameraSampler sampler;
  };

  void setUpPlacer(const SceneOptions& config, const std::vector<ObjectVariants>& variants,
                   base::Diagnostics& diagnostics);
  void setUpCameras(const SceneOptions& config, const std::vector<CameraRig>& cameras);
  [[nodiscard]] std::vector<Cuboid> objectBoxes(Stamp stamp) const;
  [[nodiscard]] randomize::PlacedObject describe(std::size_t object, const ObjectVariants& variants,
                                                 bool on_map, base::Diagnostics& diagnostics);

  std::vector<CameraRig> rigs_;
  world::World& world_;
  motion::PlacedFrames& frames_;
  std::vector<ObjectOptions> objects_;  ///< that are followed or placed
  std::vector<motion::FrameId> object_frames_;
  std::vector<motion::FrameId> distractor_frames_;  ///< of those with labels, in the world's order
  std::vector<std::vector<Cuboid>> boxes_O_;  ///< of the objects' variants, their links at rest
  std::optional<randomize::Surroundings> surroundings_;
  std::optional<randomize::ScenePlacer> placer_;
  std::optional<randomize::DistractorPlacer> distractor_placer_;
  std::optional<std::vector<int>> distractors_there_;
  std::vector<SampledCamera> cameras_;
};

}  // namespace synthetic_dataset::scene

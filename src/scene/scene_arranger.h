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

/// Places things at random, scene by scene: objects, if there is no recording to follow,
/// distractors, and cameras.
class SceneArranger {
 public:
  /// Lets the props come to rest if objects are placed among them.
  /// @param variants  of each object
  /// @param shapes, world, frames  have to outlive this
  /// @param diagnostics  receives what the user may want to know
  /// @throws ErrorList with everything that keeps objects and cameras from being placed
  SceneArranger(const SceneOptions& config, const std::vector<CameraRig>& cameras,
                const std::vector<ObjectVariants>& variants, const ObjectShapes& shapes,
                world::World& world, motion::PlacedFrames& frames, base::Diagnostics& diagnostics);

  /// Whether each scene is independent of the one before.
  [[nodiscard]] bool standsAlone() const { return placer_.has_value(); }

  /// Places the objects of an instant's scenes, if objects are placed at random; this resets the
  /// world.
  void placeObjects(std::int64_t instant);

  /// Moves the frames of objects that physics moves to their current poses in the world.
  void followProps();

  /// Places the distractors of an instant's scenes in the world's current state.
  void placeDistractors(std::int64_t instant, Stamp stamp);

  /// The numbers of the distractors that were placed last; nothing if the run has no distractors.
  [[nodiscard]] const std::optional<std::vector<int>>& distractors() const {
    return distractors_there_;
  }

  /// Places the randomly placed cameras of an instant's scenes in the world's current state.
  /// @return what the user should know about it
  [[nodiscard]] std::vector<base::Warning> placeCameras(std::int64_t instant, Stamp stamp);

 private:
  struct SampledCamera {
    motion::FrameId frame;
    std::string group;  ///< full name of its settings, for messages
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
  std::vector<std::vector<Cuboid>> boxes_O_;  ///< of the objects' variants, with their links at
                                              ///< rest
  std::optional<randomize::Surroundings> surroundings_;
  std::optional<randomize::ScenePlacer> placer_;
  std::optional<randomize::DistractorPlacer> distractor_placer_;
  std::optional<std::vector<int>> distractors_there_;
  std::vector<SampledCamera> cameras_;
};

}  // namespace synthetic_dataset::scene

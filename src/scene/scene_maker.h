#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/scene_facts.h"
#include "label/pixel_labeller.h"
#include "motion/placed_frames.h"
#include "render/renderer.h"
#include "scene/camera_poses.h"
#include "scene/camera_rig.h"
#include "scene/object_shapes.h"
#include "synthetic_dataset/label_writer.h"
#include "synthetic_dataset/scene.h"
#include "world/world.h"

namespace synthetic_dataset::scene {

/// A scene that has been seen, but still has to be labelled from what was seen.
struct SeenScene {
  Scene scene;
  label::SeenPixels pixels;
  std::vector<Pose> X_GL;  ///< of the world's links, for the optical flow

  /// The same, if each row has its own time.
  std::optional<render::RollingView> rows = std::nullopt;
};

/// Labels what a camera sees of the world in its current state; only what the writers' requirements
/// ask for.
class SceneMaker {
 public:
  /// All references have to outlive the maker.
  /// @param shapes  of the objects, in the world's order
  SceneMaker(const world::World& world, render::Renderer& renderer,
             const motion::PlacedFrames& frames, const std::vector<CameraRig>& cameras,
             const ObjectShapes& shapes, const Requirements& requirements,
             const label::PixelLabelOptions& options);

  /// What a camera sees of the world in its current state. Labels that follow from pixels are left
  /// to PendingLabels, the picture itself to the PictureTaker, the optical flow to addOpticalFlow,
  /// and the split to the caller.
  /// @param instant  the index of the scene's time in the run
  /// @param poses  of the cameras at this time
  /// @param X_GO  the objects' poses, in the objects' order
  /// @param X_GF  of other frames, which the source of motion need not have
  [[nodiscard]] SeenScene look(std::size_t camera, std::int64_t instant, Stamp stamp,
                               CameraPoses& poses, std::vector<std::optional<Pose>> X_GO,
                               const std::map<std::string, Pose>& X_GF = {});

  /// The same without what follows from pixels, which is left to lookInRows.
  [[nodiscard]] SeenScene begin(std::size_t camera, std::int64_t instant, Stamp stamp,
                                CameraPoses& poses, std::vector<std::optional<Pose>> X_GO,
                                const std::map<std::string, Pose>& X_GF) const;

  /// Labels what the camera sees if each row has its own time: replaces the labels of the instant
  /// by those of the picture. Poses stay those of the instant.
  /// @param seen  from begin()
  void lookInRows(SeenScene& seen, label::CapturedRows taken);

  /// Whether each scene has to wait for the next one.
  [[nodiscard]] bool needsOpticalFlow() const { return needs_optical_flow_; }

  /// Adds the optical flow: where the seen points have moved to in the world's current state.
  /// @param next  the cameras' poses now; null after the last scene
  void addOpticalFlow(SeenScene& seen, CameraPoses* next) const;

  /// The same if each row has its own time, also in the next scene.
  static void addOpticalFlowInRows(SeenScene& seen, const render::RollingView& next);

  /// What the manifest says about a labelled scene's objects: only what was measured.
  /// @param agreement  of its masks
  [[nodiscard]] std::vector<base::ObjectFacts> objectFacts(
      const Scene& scene, const label::MaskAgreement& agreement) const;

 private:
  /// The poses of all cameras' frames and optical frames, by frame name.
  [[nodiscard]] std::map<std::string, Pose> posesByFrame(CameraPoses& poses) const;

  const world::World& world_;
  const motion::PlacedFrames& frames_;
  const std::vector<CameraRig>& cameras_;
  const ObjectShapes& shapes_;
  bool needs_optical_flow_;
  std::vector<label::PixelLabeller> labellers_;  ///< of cameras_
};

}  // namespace synthetic_dataset::scene

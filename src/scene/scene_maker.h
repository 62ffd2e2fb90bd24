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

/// A scene that has been seen, and is still to be labelled from what was seen.
struct SeenScene {
  Scene scene;
  label::SeenPixels pixels;
  std::vector<Pose> X_GL;  ///< of the world's links, for its optical flow

  /// The same where each row has its own time.
  std::optional<render::RollingView> rows = std::nullopt;
};

/// Labels what a camera sees of the world as it stands: what the writers' requirements ask for, and
/// nothing else.
class SceneMaker {
 public:
  /// All references have to outlive the maker.
  /// @param shapes  of the objects, in the world's order
  SceneMaker(const world::World& world, render::Renderer& renderer,
             const motion::PlacedFrames& frames, const std::vector<CameraRig>& cameras,
             const ObjectShapes& shapes, const Requirements& requirements,
             const label::PixelLabelOptions& options);

  /// What a camera sees of the world as it stands now; what follows from pixels is left to
  /// PendingLabels, the picture itself to the PictureTaker, the optical flow to addOpticalFlow, the
  /// split to who plans them.
  /// @param instant  the index of the scene's time in the run
  /// @param poses  of the cameras at this time
  /// @param X_GO  the objects' poses, in their order
  /// @param X_GF  of other frames that the source of motion need not have
  [[nodiscard]] SeenScene look(std::size_t camera, std::int64_t instant, Stamp stamp,
                               CameraPoses& poses, std::vector<std::optional<Pose>> X_GO,
                               const std::map<std::string, Pose>& X_GF = {});

  /// The same without what follows from pixels, which is left to lookInRows.
  [[nodiscard]] SeenScene begin(std::size_t camera, std::int64_t instant, Stamp stamp,
                                CameraPoses& poses, std::vector<std::optional<Pose>> X_GO,
                                const std::map<std::string, Pose>& X_GF) const;

  /// What the camera sees if each row has its own time: labels of the picture in the place of those
  /// of the instant. Poses stay those of the instant.
  /// @param seen  that has begun
  void lookInRows(SeenScene& seen, label::TakenInRows taken);

  /// Whether scenes have to wait for the next one.
  [[nodiscard]] bool needsOpticalFlow() const { return needs_optical_flow_; }

  /// Where what is seen has moved to in the world as it stands now.
  /// @param next  the cameras' poses now; null after the last scene
  void addOpticalFlow(SeenScene& seen, CameraPoses* next) const;

  /// The same where each row has its own time, in the next scene too.
  static void addOpticalFlowInRows(SeenScene& seen, const render::RollingView& next);

  /// What a labelled scene's manifest gets of its objects: what was measured, and nothing else.
  /// @param agreement  of its masks
  [[nodiscard]] std::vector<base::ObjectFacts> objectFacts(
      const Scene& scene, const label::MaskAgreement& agreement) const;

 private:
  /// X_GC of all cameras, by their frames.
  [[nodiscard]] std::map<std::string, Pose> posesByFrame(CameraPoses& poses) const;

  const world::World& world_;
  const motion::PlacedFrames& frames_;
  const std::vector<CameraRig>& cameras_;
  const ObjectShapes& shapes_;
  bool needs_optical_flow_;
  std::vector<label::PixelLabeller> labellers_;  ///< of cameras_
};

}  // namespace synthetic_dataset::scene

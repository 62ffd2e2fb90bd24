#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/scene_facts.h"
#include "lidar/sweep_taker.h"
#include "render/renderer.h"
#include "run/reporter.h"
#include "run/scene_pipeline.h"
#include "run/setup/motion_setup.h"
#include "run/setup/split_plan.h"
#include "run/work_plan.h"
#include "scene/camera_poses.h"
#include "scene/object_motion.h"
#include "scene/physics_findings.h"
#include "scene/picture_taker.h"
#include "scene/row_recorder.h"
#include "scene/scene_maker.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::run {

/// Makes the scenes of one of a run's motions, one instant after another. Only one may exist at a
/// time because each owns a renderer.
class MotionRun {
 public:
  /// @param motion, splits  must outlive this
  /// @param requirements  what has to be computed for each scene
  MotionRun(MotionSetup& motion, const SplitPlan& splits, const Requirements& requirements);

  [[nodiscard]] bool isOf(const MotionSetup& motion) const { return &motion == &motion_; }

  /// The version of OpenGL.
  [[nodiscard]] std::string glVersion() const { return renderer_.glVersion(); }

  /// Makes those of the motion's scenes that are in the plan, in order.
  /// @param pipeline  receives the scenes still to be finished; this object must outlive that step
  /// @param reporter  asked before each instant whether to stop
  /// @return false if it was stopped
  [[nodiscard]] bool run(const WorkPlan& work, ScenePipeline& pipeline, Reporter& reporter);

 private:
  /// A scene that has been drawn and may be waiting for what its optical flow needs.
  struct DrawnScene {
    scene::SeenScene seen;
    render::PendingPicture image;
    scene::PendingRanges measured;  ///< measured occluders, if there are any
    lidar::PendingClouds clouds;    ///< if asked for
    std::vector<base::ContactFacts> contacts;
    std::vector<base::Warning> warnings;
    std::vector<base::DrawFacts> draws;
  };

  [[nodiscard]] bool historyCovers(std::int64_t end) const;
  void settle();
  void moveWorld(Stamp stamp);
  void advanceWorld(Stamp stamp);
  void makeInstant(std::int64_t instant, Stamp stamp, const WorkPlan& work,
                   ScenePipeline& pipeline);
  void arrange(std::int64_t instant, Stamp stamp, Duration first, bool is_wanted);
  [[nodiscard]] DrawnScene look(std::size_t camera, std::int64_t instant, Stamp stamp,
                                scene::CameraPoses& poses,
                                const std::vector<std::optional<Pose>>& X_GO);
  [[nodiscard]] std::vector<base::DrawFacts> drawsOf(std::size_t camera,
                                                     std::int64_t instant) const;
  void lookInRows(std::vector<DrawnScene>& scenes);
  void addOpticalFlow(scene::CameraPoses* now);
  void passOn(ScenePipeline& pipeline);
  void makeSweepTaker();
  [[nodiscard]] std::vector<Duration> offsetsAt(Stamp stamp) const;
  [[nodiscard]] FinishedScene finish(DrawnScene& drawn) const;
  [[nodiscard]] base::SceneFacts factsOf(const DrawnScene& drawn,
                                         const label::MaskAgreement& agreement) const;

  MotionSetup& motion_;
  const SplitPlan& splits_;
  render::Renderer renderer_;
  scene::SceneMaker scene_maker_;
  scene::PictureTaker picture_taker_;
  scene::RowRecorder row_recorder_;
  std::optional<lidar::SweepTaker> sweep_taker_;  ///< if clouds are asked for
  std::vector<Duration> offsets_;                 ///< of the pictures: see offsetsAt()
  scene::ObjectMotion object_motion_;
  scene::PhysicsFindings physics_findings_;
  Stamp motion_start_{0};                        ///< when the first shutter opens
  Stamp reached_{0};                             ///< by physics
  bool follows_history_ = false;                 ///< whether the history gives the world's state
  std::vector<base::Warning> pending_warnings_;  ///< since the last instant
  std::vector<DrawnScene> drawn_;                ///< drawn at the last instant; not yet passed on
};

}  // namespace synthetic_dataset::run

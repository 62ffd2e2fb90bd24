#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "output/manifest/scene_facts.h"
#include "render/renderer.h"
#include "run/pending_scene.h"
#include "run/work_plan.h"
#include "scene/object_motion.h"
#include "scene/picture_taker.h"
#include "scene/scene_maker.h"
#include "setup/run_setup.h"

namespace synthetic_dataset {

/// Makes the scenes of one of a run's motions, one time after another. Two of these must not be at
/// once, for each draws.
class MotionRun {
 public:
  /// Takes a scene, which is still to be finished; for that this has to live on.
  using Sink = std::function<void(PendingScene)>;

  /// @param setup  has to outlive this
  /// @param motion  of setup.motions
  /// @param sink  is given the scenes that are made, in their order
  MotionRun(const RunSetup& setup, MotionSetup& motion, Sink sink);

  [[nodiscard]] bool isOf(const MotionSetup& motion) const { return &motion == &motion_; }

  /// Of the OpenGL that draws.
  [[nodiscard]] std::string glVersion() const { return renderer_.glVersion(); }

  /// Makes the scenes that are wanted of the motion's times in turn, from the first one to the last
  /// that has any.
  /// @param is_told_to_stop  asked before each time
  /// @return false when it was told to stop
  bool run(const WorkPlan& work, const std::function<bool()>& is_told_to_stop);

 private:
  /// A scene that waits for what its optical flow needs.
  struct UnwrittenScene {
    SeenScene seen;
    render::PendingPicture image;
    std::vector<output::ContactFacts> contacts;
    std::vector<output::Warning> warnings;
    std::vector<output::DrawFacts> draws;
  };

  void settle();
  void moveWorld(Stamp stamp);
  void makeInstant(std::int64_t instant, Stamp stamp, const WorkPlan& work);
  void arrange(std::int64_t instant, Stamp stamp, bool is_wanted);
  [[nodiscard]] UnwrittenScene look(std::size_t camera, std::int64_t instant, Stamp stamp,
                                    const std::vector<Pose>& X_GO);
  [[nodiscard]] std::vector<output::DrawFacts> drawsOf(std::size_t camera,
                                                       std::int64_t instant) const;
  [[nodiscard]] std::vector<output::ContactFacts> findContacts(Stamp stamp);
  void write(std::optional<Stamp> now, const WorkPlan& work);
  [[nodiscard]] FinishedScene finish(UnwrittenScene& each) const;
  [[nodiscard]] output::SceneFacts factsOf(const UnwrittenScene& each,
                                           const MaskAgreement& agreement) const;

  MotionSetup& motion_;
  const SplitPlan& splits_;
  Sink sink_;
  render::Renderer renderer_;
  SceneMaker scene_maker_;
  PictureTaker picture_taker_;
  ObjectMotion object_motion_;
  Stamp motion_start_{0};                  ///< when the first shutter opens
  std::vector<output::Warning> news_;      ///< since the last instant
  std::vector<UnwrittenScene> unwritten_;  ///< the last time's, while they wait for the next one
};

}  // namespace synthetic_dataset

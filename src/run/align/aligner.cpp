#include "run/align/aligner.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "base/seconds.h"
#include "config/motion_list.h"
#include "label/alignment.h"
#include "run/align/camera_fit.h"
#include "run/motion_run.h"
#include "run/scene_pipeline.h"
#include "run/scene_sink.h"
#include "run/setup/input_cache.h"
#include "run/setup/motion_setup.h"
#include "run/setup/scene_plan.h"
#include "run/setup/split_plan.h"
#include "run/work_plan.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::run {
namespace {

/// How far the world advances after each scene to yield the optical flow of all motion.
constexpr Duration kProbe = std::chrono::milliseconds(5);
constexpr double kVagueTime = 0.01;  // [s] larger standard deviations make the estimate useless
constexpr int kMostRounds = 12;
constexpr double kNearest = 4.0;  // [px] search range in the last rounds

/// What was found in all scenes.
struct SeenEdges {
  std::vector<std::vector<OutlineEdge>> edges;  ///< of each scene
  label::Alignment alignment;
};

/// Collects the edges of each scene.
class EdgeSink : public SceneSink {
 public:
  EdgeSink(double reach, Pose X_FC) : reach_(reach), X_FC_(std::move(X_FC)) {}

  [[nodiscard]] Requirements requirements() const override {
    Requirements all;
    all.visible_masks = all.depth = all.optical_flow = true;
    return all;
  }
  void begin(const DatasetInfo& /*dataset*/) override {}
  [[nodiscard]] bool wants(std::int64_t /*scene*/) const override { return true; }
  void finish(RunEnd /*end*/) override {}

  [[nodiscard]] std::vector<base::Warning> add(const FinishedScene& finished) override {
    const Scene& scene = finished.scene;
    seen_.edges.push_back(findEdges(scene, {reach_, X_FC_, toSeconds(kProbe)}));
    for (const label::Alignment& each : label::alignmentsOf(scene, scene.image)) {
      seen_.alignment += each;
    }
    return {};
  }

  [[nodiscard]] const SeenEdges& seen() const { return seen_; }

 private:
  SeenEdges seen_;
  double reach_;
  Pose X_FC_;
};

MotionSetup setUp(const Value& parameters, Reporter& reporter) {
  config::MotionList list = config::readMotions(parameters);
  if (!list.errors.empty()) throw ErrorList(list.errors);
  if (list.entries.size() > 1) {
    throw ErrorList({"motions: found " + std::to_string(list.entries.size()) +
                     "; align takes the settings of one recording"});
  }
  const base::OnStage on_stage = [&](const std::string& stage) { reporter.stage(stage); };
  InputCache inputs(on_stage);
  Parameters root(list.entries.front().settings);
  config::Config config = config::readConfig(root);
  base::Diagnostics diagnostics;
  diagnostics.add(base::Severity::kError, root.errors());
  if (config.cameras.size() > 1) {
    diagnostics.error("cameras", "found " + std::to_string(config.cameras.size()) +
                                     "; align takes the settings of one camera");
  }
  if (!config.isTwin()) {
    diagnostics.error("camera/image_topic", "is missing; it names the pictures that are aligned");
  }
  diagnostics.throwIfAny();
  MotionSetup setup = setUpMotion(list.entries.front(), std::move(config), inputs, on_stage);
  setup.diagnostics.throwIfAny();
  return setup;
}

/// `count` entries of a list, evenly spread.
std::vector<Stamp> spread(const std::vector<Stamp>& all, std::size_t count) {
  std::vector<Stamp> some;
  const std::size_t taken = std::min(count, all.size());
  for (std::size_t i = 0; i < taken; ++i) some.push_back(all[i * all.size() / taken]);
  return some;
}

class Aligner {
 public:
  Aligner(MotionSetup setup, const AlignOptions& options)
      : setup_(std::move(setup)),
        finds_focal_length_(options.focal_length),
        stamps_(spread(setup_.timeline.stamps, options.scene_count)),
        X_FD_(rig().X_FD.value_or(Pose::Identity())),
        time_offset_(setup_.config.cameras.front().time_offset),
        focal_scale_(setup_.config.cameras.front().focal_scale) {
    setup_.config.twin.min_alignment = 0.0;
    setup_.config.twin.output = scene::RecordedImageOutput::kReal;
    setup_.surfaces.reset();  // an occluder's edge says nothing about the camera
  }

  CameraAlignment run(Reporter& reporter) {
    CameraAlignment found;
    constexpr double kShrink = 0.5;
    constexpr std::size_t kFew = 3;  // a third of the scenes suffices in early rounds
    double reach = std::max(12.0, rig().model.width() / 16.0);
    for (int round = 0; round < kMostRounds; ++round) {
      const bool is_near = reach <= kNearest;
      const SeenEdges seen = look(reach, round == 0 || reach <= 2.0 * kNearest ? 1 : kFew);
      if (round == 0) found.before = seen.alignment.score();
      if (reporter.stopRequested()) throw Error("stopped");
      CameraFit fit = fitCamera(seen.edges, reach, {true, finds_focal_length_});
      found.knows_time = fit.stddev[kTimeEntry] <= kVagueTime;
      if (!found.knows_time) fit = fitCamera(seen.edges, reach, {false, finds_focal_length_});
      found.stddev = fit.stddev;
      found.scenes = seen.edges.size();
      move(fit.change);
      reporter.progress(round + 1, kMostRounds);
      // The remaining change is less than a fifth of its standard deviation.
      const bool is_still =
          (fit.change.cwiseAbs().array() <= 0.2 * fit.stddev.array() + 1e-9).all();
      if (is_near && is_still) break;
      reach = std::max(kNearest, kShrink * reach);
    }
    found.after = look(kNearest, 1).alignment.score();
    found.time_offset = time_offset_;
    found.X_FD = X_FD_;
    found.focal_scale = focal_scale_;
    return found;
  }

 private:
  [[nodiscard]] scene::CameraRig& rig() { return setup_.cameras.front(); }

  /// Draws scenes with the current camera and time offset.
  /// @param every  uses every n-th scene; 1: all
  SeenEdges look(double reach, std::size_t every) {
    std::vector<Stamp> times;
    for (std::size_t i = 0; i < stamps_.size(); i += every) {
      times.push_back(stamps_[i] + moved_);
      times.push_back(stamps_[i] + moved_ + kProbe);
    }
    setup_.timeline = planScenes(*setup_.frames, setup_.config, setup_.cameras, {},
                                 setup_.driven_links, std::move(times));
    rig().X_FD = X_FD_;
    setup_.world->restart();
    const std::int64_t count = setup_.instantCount();
    const SplitPlan no_splits({}, 0, {{count, std::nullopt, {}}});
    const Pose X_FC = rig().optical_frame == rig().frame ? Pose::Identity() : rig().X_FC;
    EdgeSink sink(reach, X_FC);
    Reporter silent;
    MotionRun run(setup_, no_splits, sink.requirements());
    ScenePipeline pipeline(sink, silent, count);
    // Times at which TF is unknown have been left out.
    const std::vector<Stamp>& there = setup_.timeline.stamps;
    const WorkPlan probed(count, 1, [&](std::int64_t scene) {
      const auto next = static_cast<std::size_t>(scene) + 1;
      return next < there.size() && there[next] - there[next - 1] == kProbe;
    });
    (void)run.run(probed, pipeline, silent);
    pipeline.finish();
    return sink.seen();
  }

  void move(const AlignmentVector& change) {
    const Eigen::Vector3d turn = change.segment<3>(3);
    const double angle = turn.norm();
    constexpr double kNoTurn = 1e-12;  // [rad]
    const Eigen::Quaterniond rotation(
        Eigen::AngleAxisd(angle, angle > kNoTurn ? Eigen::Vector3d(turn / angle)
                                                 : Eigen::Vector3d(Eigen::Vector3d::UnitX())));
    X_FD_ = X_FD_ * makePose(change.head<3>(), rotation);
    const double scale = std::exp(change[kFocalEntry]);
    focal_scale_ *= scale;
    rig().model = scene::withFocalScale(rig().model, scale);
    const Duration later = base::fromSeconds(change[kTimeEntry]);
    moved_ += later;
    time_offset_ += later;
    setup_.pictures->shift(later);
  }

  MotionSetup setup_;
  bool finds_focal_length_;
  std::vector<Stamp> stamps_;  ///< of the scenes, with the time offset as configured
  Pose X_FD_;
  Duration time_offset_;
  double focal_scale_;
  Duration moved_{0};  ///< change of time_offset_ since then
};

}  // namespace

CameraAlignment alignCamera(const Value& parameters, const AlignOptions& options,
                            Reporter& reporter) {
  return Aligner(setUp(parameters, reporter), options).run(reporter);
}

}  // namespace synthetic_dataset::run

#include "motion/frame_motion.h"

#include <utility>

#include "motion/frame_names.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {

const Pose& nowhere() {
  constexpr double kDepth = 1e5;  // [m]
  static const Pose X_GF = makePose({0, 0, -kDepth}, Eigen::Quaterniond::Identity());
  return X_GF;
}

FrameMotion::FrameMotion(std::string global_frame, std::shared_ptr<const BagMotion> recording)
    : global_frame_(withoutLeadingSlashes(std::move(global_frame))),
      recording_(std::move(recording)) {}

void FrameMotion::place(const std::string& frame, const Pose& X_GF) {
  placed_[withoutLeadingSlashes(frame)] = X_GF;
}

bool FrameMotion::isPlaced(const std::string& frame) const {
  return placed_.count(withoutLeadingSlashes(frame)) != 0;
}

bool FrameMotion::isGlobal(const std::string& frame) const {
  return withoutLeadingSlashes(frame) == global_frame_;
}

bool FrameMotion::knowsFrame(const std::string& frame) const {
  if (isPlaced(frame)) return true;
  return recording_ ? recording_->knowsFrame(frame) : isGlobal(frame);
}

std::string FrameMotion::suggestFrame(const std::string& frame) const {
  if (recording_) return recording_->suggestFrame(frame);
  std::vector<std::string> names{global_frame_};
  for (const auto& [name, pose] : placed_) names.push_back(name);
  return didYouMeanFrame(withoutLeadingSlashes(frame), names);
}

Pose FrameMotion::pose(const std::string& frame, Stamp time) const {
  const std::string name = withoutLeadingSlashes(frame);
  const auto placed = placed_.find(name);
  if (placed != placed_.end()) return placed->second;
  if (recording_) return recording_->transform(global_frame_, name, time);
  if (isGlobal(name)) return Pose::Identity();
  throw Error("the frame '" + name + "' is not known" + suggestFrame(name));
}

bool FrameMotion::hasPose(const std::string& frame, Stamp time) const {
  if (isPlaced(frame)) return true;
  if (recording_) return recording_->canTransform(global_frame_, frame, time);
  return isGlobal(frame);
}

}  // namespace synthetic_dataset::motion

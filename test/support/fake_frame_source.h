#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "motion/frame_source.h"

namespace synthetic_dataset::test {

/// A source of motion that is made in one line:
///   FakeFrameSource source({{"alpha", [](Stamp time) { return poseAt(toSeconds(time), 0, 0); }}});
class FakeFrameSource : public motion::FrameSource {
 public:
  /// X_GF by time; nothing when it is not known.
  using PoseAt = std::function<std::optional<Pose>(Stamp time)>;

  explicit FakeFrameSource(const std::map<std::string, PoseAt>& frames = {},
                           const std::string& global_frame = "map")
      : FrameSource(global_frame) {
    for (const auto& [name, pose] : frames) {
      static_cast<void>(names_.findOrAdd(name));
      poses_.push_back(pose);
    }
  }

  /// A frame that stands still.
  [[nodiscard]] static PoseAt fixed(const Pose& X_GF) {
    return [X_GF](Stamp) { return X_GF; };
  }

  [[nodiscard]] const motion::FrameNames& names() const override { return names_; }

  [[nodiscard]] std::optional<Pose> pose(motion::FrameId frame, Stamp time) const override {
    if (frame == motion::kNoFrame) return std::nullopt;
    return poses_[static_cast<std::size_t>(frame)](time);
  }

  /// One scene a period from 0 on, as many as are asked for.
  [[nodiscard]] motion::Timeline timeline(const std::vector<std::string>& /*frames*/,
                                          const motion::TimelineOptions& options) const override {
    motion::Timeline timeline;
    for (std::int64_t i = 0; i < options.scenes; ++i) timeline.stamps.push_back(i * options.period);
    return timeline;
  }

  [[nodiscard]] std::string title() const override { return "the fake"; }

 private:
  motion::FrameNames names_;
  std::vector<PoseAt> poses_;
};

}  // namespace synthetic_dataset::test

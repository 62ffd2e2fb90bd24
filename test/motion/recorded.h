#pragma once

#include <functional>
#include <string>
#include <vector>

#include "motion/bag_motion.h"
#include "support/bag_builder.h"

namespace synthetic_dataset::motion {

/// The motion in a temporary bag, which is deleted once it has been read.
[[nodiscard]] BagMotion recorded(const std::function<void(test::BagBuilder&)>& write,
                                 const std::string& global_frame = "map");

/// X_GF of a frame, by its name.
/// @throws Error when it is not known
[[nodiscard]] Pose poseOf(const FrameSource& source, const std::string& frame, Stamp time);

[[nodiscard]] bool isKnown(const FrameSource& source, const std::string& frame, Stamp time);

/// One scene every `period_ms` from the recording's start to its end.
[[nodiscard]] TimelineOptions everyMilliseconds(std::int64_t period_ms);

/// A frame's transforms from `first_ms` to `last_ms`, both included; at time t its x is t in
/// seconds.
void moveAlongX(test::BagBuilder& bag, const std::string& parent, const std::string& child,
                std::int64_t first_ms, std::int64_t last_ms, std::int64_t step_ms = 100);

/// The warnings that the source reports when these frames are used.
[[nodiscard]] std::vector<std::string> warningsOf(const FrameSource& source,
                                                  const std::vector<std::string>& frames);

/// The message of the Error that the call throws; fails the test if it throws none.
[[nodiscard]] std::string messageOf(const std::function<void()>& call);

}  // namespace synthetic_dataset::motion

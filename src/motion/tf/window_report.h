#pragma once

#include <string>
#include <vector>

#include "motion/tf/bag_reader.h"
#include "motion/tf/frame_tree.h"
#include "motion/timeline.h"
#include "motion/timeline_search.h"

namespace synthetic_dataset::motion {

/// Errors about the frames' names: one message for each frame that the recording does not have,
/// with similarly spelt ones that it has.
[[nodiscard]] std::vector<std::string> unknownFrames(const FrameTree& tree,
                                                     const std::string& global_frame,
                                                     const std::vector<std::string>& frames);

/// When a frame is known: "from 1.000000000 s to 3.000000000 s (0.000 s to 2.000 s after the
/// recording's start)", ...
[[nodiscard]] std::string stretchesText(const std::vector<Validity>& times, Stamp start);

/// How much of a part of the recording is lost because frames are not known all the time; the
/// crossed link that is known for the shortest time is to blame.
[[nodiscard]] std::vector<FrameCost> frameCosts(const FrameTree& tree, const FramesToKnow& wanted,
                                                const RecordedTimes& part);

/// Why there is no time at which all frames are known: lists the times at which each one is.
[[nodiscard]] std::vector<std::string> whyNoWindow(const FrameTree& tree,
                                                   const FramesToKnow& wanted,
                                                   const RecordedTimes& recorded,
                                                   const RecordedTimes& part,
                                                   const TimelineOptions& options);

}  // namespace synthetic_dataset::motion

#pragma once

#include <string>
#include <vector>

#include "motion/tf/bag_reader.h"
#include "motion/tf/frame_tree.h"
#include "motion/timeline.h"
#include "motion/timeline_search.h"

namespace synthetic_dataset::motion {

/// What is wrong with the names alone: one message for each that the recording does not have, with
/// those that it has and that are spelt nearly like it.
[[nodiscard]] std::vector<std::string> unknownFrames(const FrameTree& tree,
                                                     const std::string& global_frame,
                                                     const std::vector<std::string>& frames);

/// When a frame is known: "from 1.000000000 s to 3.000000000 s (0.000 s to 2.000 s after the
/// recording's start)", ...
[[nodiscard]] std::string stretchesText(const std::vector<Validity>& times, Stamp start);

/// What frames that are not known all the time cost of a part of the recording; of links that are
/// crossed, the one that is known the shortest is to blame.
[[nodiscard]] std::vector<FrameCost> frameCosts(const FrameTree& tree, const FramesToKnow& wanted,
                                                const RecordedTimes& part);

/// Why there is no time at which all frames are known: the times of each.
[[nodiscard]] std::vector<std::string> whyNoWindow(const FrameTree& tree,
                                                   const FramesToKnow& wanted,
                                                   const RecordedTimes& recorded,
                                                   const RecordedTimes& part,
                                                   const TimelineOptions& options);

}  // namespace synthetic_dataset::motion

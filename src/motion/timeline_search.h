#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/tf/bag_reader.h"
#include "motion/tf/frame_tree.h"
#include "motion/timeline.h"

namespace synthetic_dataset::motion {

/// The frames that have to be known, in the global frame, at the times of a timeline.
struct FramesToKnow {
  FrameId global_frame = kNoFrame;
  std::vector<FrameId> frames;
};

/// Whether a link's pose at a time is interpolated across a longer gap than the options allow.
[[nodiscard]] bool isForbidden(const LinkHistory& link, Stamp time,
                               const std::optional<Duration>& max_tf_gap);

/// What is wrong with the options: they leave nothing of the recording, ...
[[nodiscard]] std::vector<std::string> optionErrors(const RecordedTimes& recorded,
                                                    const TimelineOptions& options);

/// The part of the recording that the options leave: from its start + start_offset, for at most
/// `duration`.
/// @param options  without optionErrors()
[[nodiscard]] RecordedTimes usedPart(const RecordedTimes& recorded, const TimelineOptions& options);

/// From the first to the last time at which all frames are known; nothing if there is no such time.
/// @param part  in which to search
[[nodiscard]] std::optional<RecordedTimes> knownTimes(const FrameTree& tree,
                                                      const FramesToKnow& wanted,
                                                      const RecordedTimes& part);

/// The timeline by the rules of BagMotion::timeline(), or nothing if there is no time at which all
/// frames are known.
/// @param part  from usedPart()
/// @throws ErrorList if there are more scenes than file names can number
[[nodiscard]] std::optional<Timeline> findTimeline(const FrameTree& tree,
                                                   const FramesToKnow& wanted,
                                                   const RecordedTimes& part,
                                                   const TimelineOptions& options);

}  // namespace synthetic_dataset::motion

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/tf/bag_reader.h"
#include "motion/tf/frame_tree.h"
#include "motion/timeline.h"

namespace synthetic_dataset::motion {

/// What a timeline is looked for: frames that have to be known in the global frame.
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

/// From the first to the last time at which all frames are known; nothing where there is none.
/// @param part  in which to look
[[nodiscard]] std::optional<RecordedTimes> knownTimes(const FrameTree& tree,
                                                      const FramesToKnow& wanted,
                                                      const RecordedTimes& part);

/// The timeline by the rules of BagMotion::timeline(), or nothing when there is no time at which
/// all frames are known.
/// @param part  of usedPart()
/// @throws ErrorList: more scenes than file names can number
[[nodiscard]] std::optional<Timeline> findTimeline(const FrameTree& tree,
                                                   const FramesToKnow& wanted,
                                                   const RecordedTimes& part,
                                                   const TimelineOptions& options);

}  // namespace synthetic_dataset::motion

#include "motion/frame_source.h"

#include "motion/bag/ros_time.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {

Pose FrameSource::knownPose(FrameId frame, Stamp time) const {
  if (const auto X_GF = pose(frame, time)) return *X_GF;
  throw Error(frame == kNoFrame
                  ? title() + " does not have a frame that is needed"
                  : "the frame '" + names().of(frame) + "' is not known in '" + global_frame_ +
                        "' at " + secondsText(time) + whenKnown(frame));
}

std::string FrameSource::lacks(const std::string& frame) const {
  return title() + " has no frame '" + frame + "'" + didYouMeanFrame(frame, names().all());
}

}  // namespace synthetic_dataset::motion

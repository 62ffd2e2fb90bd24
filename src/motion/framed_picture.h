#pragma once

#include <string>

#include <rosbag/message_instance.h>

#include "motion/recorded_pictures.h"

namespace synthetic_dataset::motion {

/// A message's picture, with what its header has.
struct FramedPicture {
  Stamp stamp{0};
  std::string frame;  ///< without leading slashes
  RecordedPicture picture;
};

/// Of a sensor_msgs/Image or a sensor_msgs/CompressedImage.
/// @throws Error for any other message
[[nodiscard]] FramedPicture framedPicture(const rosbag::MessageInstance& message);

}  // namespace synthetic_dataset::motion

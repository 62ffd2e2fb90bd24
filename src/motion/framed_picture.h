#pragma once

#include <functional>
#include <optional>
#include <string>

#include <rosbag/message_instance.h>

#include "base/image/picture_size.h"

#include "motion/recorded_pictures.h"

namespace synthetic_dataset::motion {

/// A message's picture, with what its header has.
struct FramedPicture {
  Stamp stamp{0};
  std::string frame;  ///< without leading slashes
  RecordedPicture picture;
};

/// Reads a sensor_msgs/Image or a sensor_msgs/CompressedImage.
/// @throws Error for any other message
[[nodiscard]] FramedPicture framedPicture(const rosbag::MessageInstance& message);

/// What is known of a picture without decoding it.
/// @param problem_of  why a raw picture cannot be read, if so
/// @param size_of  looks at a picture that is a file; throws Error where it cannot be read
[[nodiscard]] PictureHead headOf(
    const FramedPicture& framed,
    const std::function<std::optional<std::string>(const base::RawPicture&)>& problem_of,
    const std::function<base::PictureSize(const PictureFile&)>& size_of);

}  // namespace synthetic_dataset::motion

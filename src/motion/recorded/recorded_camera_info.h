#pragma once

#include <string>
#include <vector>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::motion {

/// A recorded calibration of a camera.
struct RecordedCameraInfo {
  Value info;         ///< a map with the message's own names: width, height, K, D, P, ...
  std::string frame;  ///< its optical frame, from the message's header
  std::vector<std::string> notes;  ///< if later messages differ
};

/// The first sensor_msgs/CameraInfo of a topic, from the first bag that has any.
/// @param bag_files  bags that can be read
/// @throws Error if no bag has such a topic (listing the topics of its type), or its messages are
///     of another type
[[nodiscard]] RecordedCameraInfo readCameraInfo(const std::vector<std::string>& bag_files,
                                                const std::string& topic);

}  // namespace synthetic_dataset::motion

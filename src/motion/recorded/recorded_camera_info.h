#pragma once

#include <string>
#include <vector>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::motion {

/// What a recorded camera says of itself.
struct RecordedCameraInfo {
  Value info;         ///< a map with the message's own names: width, height, K, D, P, ...
  std::string frame;  ///< of its optical frame, as the message's header has it
  std::vector<std::string> notes;  ///< when later messages say something else
};

/// The first sensor_msgs/CameraInfo of a topic, of the first bag that has any.
/// @param bag_files  bags that can be read
/// @throws Error when no bag has such a topic (with those of its type that there are) or it has
///     messages of another type
[[nodiscard]] RecordedCameraInfo readCameraInfo(const std::vector<std::string>& bag_files,
                                                const std::string& topic);

}  // namespace synthetic_dataset::motion

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "motion/recorded/recorded_pictures.h"

namespace synthetic_dataset::motion {

/// The depth images of a topic of type sensor_msgs/Image (32FC1, 16UC1) or
/// sensor_msgs/CompressedImage (compressedDepth), in bags that count as one recording.
class RecordedDepths : public RecordedMessages<PictureHead> {
 public:
  /// Looks at all messages of the topic, and remembers where they are.
  /// @throws Error as RecordedPictures does
  RecordedDepths(const std::vector<std::string>& bag_files, const std::string& topic);

  /// Reads an image of heads(): CV_32FC1, z of the seen surfaces [m], 0 where nothing was measured.
  /// May be called in any thread.
  /// @throws Error if it cannot be decoded
  [[nodiscard]] cv::Mat read(std::size_t index) const;
};

}  // namespace synthetic_dataset::motion

#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "motion/recorded/recorded_pictures.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// The depth images of a topic of type sensor_msgs/Image (32FC1, 16UC1) or
/// sensor_msgs/CompressedImage (compressedDepth), in bags that count as one recording.
class RecordedDepths {
 public:
  /// Looks at all messages of the topic, and keeps where they are.
  /// @throws Error as RecordedPictures does
  RecordedDepths(const std::vector<std::string>& bag_files, const std::string& topic);
  ~RecordedDepths();
  RecordedDepths(RecordedDepths&&) noexcept;
  RecordedDepths& operator=(RecordedDepths&&) noexcept;

  /// All images in order of stamp; at least one.
  [[nodiscard]] const std::vector<PictureHead>& heads() const;

  /// An image of heads(), in any thread. CV_32FC1: z of what is seen [m]; 0 where nothing was
  /// measured.
  /// @throws Error where it cannot be decoded
  [[nodiscard]] cv::Mat read(std::size_t index) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::motion

#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>
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

/// What is known of a cloud without keeping its points.
struct CloudHead {
  Stamp stamp{0};            ///< that its message's header has
  std::string frame;         ///< likewise, without leading slashes
  std::string problem = {};  ///< why it cannot be read: "has no field z, ..."
};

/// The clouds of a topic of type sensor_msgs/PointCloud2, in bags that count as one recording.
class RecordedClouds {
 public:
  /// Looks at all messages of the topic, and keeps where they are.
  /// @throws Error as RecordedPictures does
  RecordedClouds(const std::vector<std::string>& bag_files, const std::string& topic);
  ~RecordedClouds();
  RecordedClouds(RecordedClouds&&) noexcept;
  RecordedClouds& operator=(RecordedClouds&&) noexcept;

  /// All clouds in order of stamp; at least one.
  [[nodiscard]] const std::vector<CloudHead>& heads() const;

  /// The points of a cloud of heads() [m], in any thread; those that are not finite are left out.
  /// @throws Error where it cannot be read
  [[nodiscard]] std::vector<Eigen::Vector3d> read(std::size_t index) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::motion

#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "label/label_options.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::scene {

/// Which pictures the scenes contain.
enum class RecordedImageOutput {
  kReal,       ///< the recorded ones
  kSynthetic,  ///< pictures drawn of the same instants
};

/// How recorded pictures of cameras with an `image_topic` are labelled.
struct RecordedImageOptions {
  RecordedImageOutput output = RecordedImageOutput::kReal;
  std::int64_t every = 1;  ///< every n-th picture of the topic is a scene

  double min_alignment = 0.0;  ///< scenes below it are left out (label::Alignment), 0 .. 1

  std::optional<std::string> depth_topic;       ///< of the bag: a depth camera's images
  std::optional<std::string> depth_info_topic;  ///< of the bag: its calibration
  bool depth_is_rectified = false;              ///< otherwise it has the lens's distortion
  std::optional<std::string> cloud_topic;       ///< of the bag: a scanner's clouds
  label::OcclusionMargin margin;  ///< how far in front of an object something hides it

  /// Largest difference between the stamps of a picture and of its depth image or cloud.
  Duration depth_time = std::chrono::milliseconds(50);

  [[nodiscard]] bool isMeasured() const { return depth_topic || cloud_topic; }

  /// Largest difference between the stamps of the cameras' pictures of one scene.
  Duration same_time = std::chrono::milliseconds(1);
};

}  // namespace synthetic_dataset::scene

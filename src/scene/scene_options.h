#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "label/label_options.h"
#include "lidar/lidar_options.h"
#include "motion/motion_options.h"
#include "randomize/appearance/randomize_options.h"
#include "randomize/placement/placement_options.h"
#include "scene/camera_options.h"
#include "scene/object_options.h"
#include "scene/recorded_image_options.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::scene {

/// What a motion's scenes are made of: what is where, how it looks, who sees it.
struct SceneOptions {
  /// Whether scenes are placed at random, not recorded.
  [[nodiscard]] bool isPlaced() const { return motion.source == motion::MotionSource::kPlacement; }

  /// Whether the scenes' images are recorded ones.
  [[nodiscard]] bool hasRecordedImages() const {
    return isTwin() && twin.output == RecordedImageOutput::kReal;
  }

  /// Whether scenes are at the times of recorded pictures.
  [[nodiscard]] bool isTwin() const {
    return std::any_of(cameras.begin(), cameras.end(),
                       [](const CameraOptions& each) { return each.image_topic.has_value(); });
  }

  /// The lidar at the times of whose recorded clouds scenes are, as no pictures say when: the first
  /// that has some. Null: none.
  [[nodiscard]] const lidar::LidarOptions* timingLidar() const {
    const auto found =
        std::find_if(lidars.begin(), lidars.end(),
                     [](const lidar::LidarOptions& each) { return each.recorded.has_value(); });
    return isTwin() || found == lidars.end() ? nullptr : &*found;
  }

  /// Whether scenes are at the times of something that was recorded, and not at regular ones.
  [[nodiscard]] bool hasRecordedTimes() const { return isTwin() || timingLidar() != nullptr; }

  /// How many objects are followed or placed, and no distractors.
  [[nodiscard]] std::size_t robotCount() const {
    std::size_t count = 0;
    for (const ObjectOptions& object : objects) count += object.is_distractor ? 0 : 1;
    return count;
  }

  std::string global_frame = "map";
  motion::MotionOptions motion;
  randomize::PlacementOptions placement;  ///< of MotionSource::kPlacement
  randomize::Randomization randomization;
  std::vector<CameraOptions> cameras;  ///< at least one
  std::vector<lidar::LidarOptions> lidars;
  RecordedImageOptions twin;  ///< of cameras with an image_topic
  std::vector<ObjectOptions> objects;
  label::MaskOptions masks;
  label::LabelOptions labels;
  Duration settling{0};   ///< simulated before the first scene
  std::int64_t seed = 0;  ///< of all that is random
};

}  // namespace synthetic_dataset::scene

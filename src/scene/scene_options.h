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

/// What a motion's scenes consist of: objects and their poses, their look, cameras and lidars.
struct SceneOptions {
  /// Whether scenes are placed at random rather than recorded.
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

  /// The lidar whose recorded clouds determine the times of scenes, if no pictures do: the first
  /// lidar with recorded clouds. Null if there is none.
  [[nodiscard]] const lidar::LidarOptions* timingLidar() const {
    const auto found =
        std::find_if(lidars.begin(), lidars.end(),
                     [](const lidar::LidarOptions& each) { return each.recorded.has_value(); });
    return isTwin() || found == lidars.end() ? nullptr : &*found;
  }

  /// Whether scenes are at the times of recorded pictures or clouds, rather than at regular times.
  [[nodiscard]] bool hasRecordedTimes() const { return isTwin() || timingLidar() != nullptr; }

  /// The number of objects that are followed or placed, without distractors.
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
  std::int64_t seed = 0;  ///< of everything random
};

}  // namespace synthetic_dataset::scene

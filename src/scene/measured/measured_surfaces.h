#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "base/diagnostics.h"
#include "motion/frame_source.h"
#include "scene/camera_pictures.h"
#include "scene/camera_rig.h"
#include "scene/recorded_image_options.h"
#include "synthetic_dataset/pose.h"
#include "world/world.h"

namespace synthetic_dataset::scene {

/// What was measured where a picture was taken, in any thread: see range_image.h. Empty where
/// nothing was measured near its time.
using PendingRanges = std::function<cv::Mat()>;

/// What a depth camera and a scanner have recorded of the surfaces that pictures show.
class MeasuredSurfaces {
 public:
  /// @param twin  with a depth_topic or a cloud_topic
  /// @param cameras  of the pictures
  /// @param frames  has to outlive this
  /// @throws ErrorList naming the settings, when something cannot be read, or nobody knows where it
  ///     was measured
  MeasuredSurfaces(const RecordedImageOptions& twin, const std::vector<std::string>& bag_files,
                   const std::vector<CameraRig>& cameras, const CameraPictures& pictures,
                   const motion::FrameSource& frames);
  ~MeasuredSurfaces();

  /// Counts the scenes of which nothing was measured; an error where that are all.
  void check(const std::vector<Stamp>& times, base::Diagnostics& diagnostics) const;

  /// What was measured of what a camera sees at a time, at which the world stands.
  /// @param X_GC  of the picture's optical frame
  [[nodiscard]] PendingRanges seenBy(std::size_t camera, const world::World& world, Stamp time,
                                     const Pose& X_GC) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::scene

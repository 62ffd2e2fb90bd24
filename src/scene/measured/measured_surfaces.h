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

/// Returns the ranges that were measured for a picture (see range_image.h); empty if nothing was
/// measured near its time. May be called in any thread.
using PendingRanges = std::function<cv::Mat()>;

/// The surfaces shown in pictures, as recorded by a depth camera and a scanner.
class MeasuredSurfaces {
 public:
  /// @param twin  with a depth_topic or a cloud_topic
  /// @param cameras  of the pictures
  /// @param frames  has to outlive this
  /// @throws ErrorList naming the settings, if something cannot be read, or if it is unknown where
  ///     it was measured
  MeasuredSurfaces(const RecordedImageOptions& twin, const std::vector<std::string>& bag_files,
                   const std::vector<CameraRig>& cameras, const CameraPictures& pictures,
                   const motion::FrameSource& frames);
  ~MeasuredSurfaces();

  /// Warns of scenes for which nothing was measured; an error if that is all of them.
  void check(const std::vector<Stamp>& times, base::Diagnostics& diagnostics) const;

  /// What was measured of the surfaces that a camera sees at a time, which is that of the world's
  /// current state.
  /// @param X_GC  of the picture's optical frame
  [[nodiscard]] PendingRanges seenBy(std::size_t camera, const world::World& world, Stamp time,
                                     const Pose& X_GC) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::scene

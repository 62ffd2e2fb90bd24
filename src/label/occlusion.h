#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "label/label_options.h"

namespace synthetic_dataset::label {

/// Where something stands in front of what the world has: CV_8UC1, 255 there.
///
/// What is known within two pixels counts as known, so that inner outlines of an object, which
/// are never a pixel exact, do not cut it.
/// @param known  CV_32FC1, of what the world has: distances from the camera's centre [m]; 0 where
///     nothing is
/// @param measured  CV_32FC1, the same of what was measured; 0 where nothing was
[[nodiscard]] cv::Mat coveredPixels(const cv::Mat& known, const cv::Mat& measured,
                                    const OcclusionMargin& margin);

/// How much of what an object shows was measured, before anything was cut off.
struct ObjectCover {
  std::int64_t pixels = 0;      ///< that it would show if nothing but the world were there
  std::int64_t unmeasured = 0;  ///< of these: nothing was measured there
  std::int64_t covered = 0;     ///< of these: something stands in front

  ObjectCover& operator+=(const ObjectCover& other);

  /// The shares of its pixels, 0 .. 1; 0 of an object without pixels.
  [[nodiscard]] double unmeasuredShare() const;
  [[nodiscard]] double coveredShare() const;
};

/// The occlusion of each object.
/// @param ids  CV_32SC1: an object's index + 1, 0 for the world
/// @param measured  as for coveredPixels; empty: nothing was measured at all
/// @param covered  of coveredPixels(); empty likewise
[[nodiscard]] std::vector<ObjectCover> objectCovers(const cv::Mat& ids, const cv::Mat& measured,
                                                    const cv::Mat& covered,
                                                    std::size_t object_count);

}  // namespace synthetic_dataset::label

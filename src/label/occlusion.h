#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "label/label_options.h"

namespace synthetic_dataset::label {

/// The pixels where something stands in front of the world's surfaces: CV_8UC1, 255 there.
///
/// A measurement counts only if it is in front of all known surfaces within two pixels, so that
/// inner outlines of an object, which are never exact to the pixel, do not cut it.
/// @param known  CV_32FC1: distances of the world's surfaces from the camera's centre [m]; 0 where
///     there is nothing
/// @param measured  CV_32FC1: the same for the measured surfaces; 0 where nothing was measured
[[nodiscard]] cv::Mat coveredPixels(const cv::Mat& known, const cv::Mat& measured,
                                    const OcclusionMargin& margin);

/// How much of an object's visible surface was measured, before anything was cut off.
struct ObjectCover {
  std::int64_t pixels = 0;      ///< that would show it if nothing but the world were there
  std::int64_t unmeasured = 0;  ///< those of them where nothing was measured
  std::int64_t covered = 0;     ///< those of them where something stands in front

  ObjectCover& operator+=(const ObjectCover& other);

  /// The shares of its pixels, 0 .. 1; 0 for an object without pixels.
  [[nodiscard]] double unmeasuredShare() const;
  [[nodiscard]] double coveredShare() const;
};

/// The occlusion of each object.
/// @param ids  CV_32SC1: an object's index + 1, 0 for the world
/// @param measured  as for coveredPixels; empty: nothing was measured at all
/// @param covered  from coveredPixels(); empty if `measured` is
[[nodiscard]] std::vector<ObjectCover> objectCovers(const cv::Mat& ids, const cv::Mat& measured,
                                                    const cv::Mat& covered,
                                                    std::size_t object_count);

}  // namespace synthetic_dataset::label

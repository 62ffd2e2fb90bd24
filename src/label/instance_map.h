#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/mask.h"

namespace synthetic_dataset::label {

/// The pixels of one object in an instance map.
struct InstancePixels {
  std::int64_t count = 0;
  cv::Rect bounds;  ///< empty if there are none
};

/// Converts identifiers to an instance map: the same numbers, as CV_16UC1.
/// @param ids  CV_32SC1: an object's index + 1, 0 for the world
[[nodiscard]] cv::Mat instanceMap(const cv::Mat& ids);

/// Combines masks that were each found with a single object in view into an instance map, layered
/// by depth: where the identifiers show an object, a pixel belongs to that object or to none; where
/// they show none (at outlines, subtraction and identifiers differ by a pixel), to the nearest
/// object whose mask contains it.
/// @param masks  of all objects, in the objects' order
/// @param ids  as for instanceMap
/// @param distances  to the objects [m]
[[nodiscard]] cv::Mat layeredInstanceMap(const std::vector<Mask>& masks, const cv::Mat& ids,
                                         const std::vector<double>& distances);

/// The pixels of each object in the map, in the objects' order.
[[nodiscard]] std::vector<InstancePixels> instancePixels(const cv::Mat& instance_map,
                                                         std::size_t object_count);

/// One object's part of the map: the pixels with the value `instance`.
/// @param bounds  the box around its pixels
[[nodiscard]] Mask instanceMask(const cv::Mat& instance_map, int instance, const cv::Rect& bounds);

/// Replaces each instance's number in the map: CV_16UC1.
/// @param numbers  of the objects, in the objects' order; the world stays 0
[[nodiscard]] cv::Mat renumbered(const cv::Mat& instance_map,
                                 const std::vector<std::uint16_t>& numbers);

/// Intersection over union of two maps, object by object: pixels that both assign to the object /
/// pixels that either does. Nothing for objects that the second map does not show.
[[nodiscard]] std::vector<std::optional<double>> intersectionOverUnion(const cv::Mat& found,
                                                                       const cv::Mat& exact,
                                                                       std::size_t object_count);

}  // namespace synthetic_dataset::label

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/mask.h"

namespace synthetic_dataset::label {

/// The pixels that one object has in an instance map.
struct InstancePixels {
  std::int64_t count = 0;
  cv::Rect bounds;  ///< empty where there is none
};

/// Identifiers as an instance map: the same numbers, CV_16UC1.
/// @param ids  CV_32SC1: an object's index + 1, 0 for the world
[[nodiscard]] cv::Mat instanceMap(const cv::Mat& ids);

/// An instance map of masks that were each found with one object in view, layered as the objects
/// stand: where the identifiers show an object, a pixel belongs to it or to nobody; where they show
/// none (at outlines, subtraction and identifiers differ by a pixel), to the nearest object that
/// has it in its mask.
/// @param masks  of all objects, in their order
/// @param ids  as for instanceMap
/// @param distances  of the objects [m]
[[nodiscard]] cv::Mat layeredInstanceMap(const std::vector<Mask>& masks, const cv::Mat& ids,
                                         const std::vector<double>& distances);

/// What each object has in the map, in their order.
[[nodiscard]] std::vector<InstancePixels> instancePixels(const cv::Mat& instance_map,
                                                         std::size_t object_count);

/// One object's part of the map: where the map has `instance`.
/// @param bounds  around its pixels
[[nodiscard]] Mask instanceMask(const cv::Mat& instance_map, int instance, const cv::Rect& bounds);

/// The map with each instance's number replaced: CV_16UC1.
/// @param numbers  of the objects, in their order; the world stays 0
[[nodiscard]] cv::Mat renumbered(const cv::Mat& instance_map,
                                 const std::vector<std::uint16_t>& numbers);

/// Pixels that two maps agree are the object's / pixels that either says are, object by object;
/// nothing for those that the second map does not show.
[[nodiscard]] std::vector<std::optional<double>> intersectionOverUnion(const cv::Mat& found,
                                                                       const cv::Mat& exact,
                                                                       std::size_t object_count);

}  // namespace synthetic_dataset::label

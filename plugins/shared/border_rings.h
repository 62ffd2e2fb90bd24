#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <opencv2/core/types.hpp>

#include "synthetic_dataset/mask.h"

/// The borders of a mask's parts as closed rings, and how several rings are joined into one.
namespace synthetic_dataset::masks {

/// A step along a border: the pixel corner at which it begins, and the mask's pixel on its right
/// side. Corner (x, y) is the top left corner of pixel (x, y).
struct BorderStep {
  cv::Point corner;
  cv::Point pixel;
};
using BorderRing = std::vector<BorderStep>;  ///< closed: the last step leads to the first

/// The border of each part of a mask, in the order of their topmost, leftmost pixels. Pixels that
/// share a corner belong to the same part. Holes are cut open: the ring branches off at a pixel
/// above the hole, goes straight down to it, around it and back the same way.
[[nodiscard]] std::vector<BorderRing> partBorders(const Mask& mask);

/// A branch from one ring into another.
struct Branch {
  std::size_t ring = 0;   ///< the other ring
  std::size_t start = 0;  ///< the other ring's step visited first, and once more at the end
};

/// All branches, by the ring and step at which they leave.
using Branches = std::map<std::pair<std::size_t, std::size_t>, std::vector<Branch>>;

/// Joins several rings into one: a walk around `root` that, at each branch, goes around the other
/// ring (including that ring's own branches) and returns to the step where it left.
/// @param branches  without cycles
[[nodiscard]] BorderRing walk(const std::vector<BorderRing>& rings, const Branches& branches,
                              const Branch& root);

}  // namespace synthetic_dataset::masks

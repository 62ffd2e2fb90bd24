#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <opencv2/core/types.hpp>

#include "synthetic_dataset/mask.h"

/// The borders of a mask's parts as closed rings, and how several rings become one.
namespace synthetic_dataset::masks {

/// A place on a border: the corner of pixels at which a step along it begins, and the pixel of the
/// mask at the step's right side. Corner (x, y) is the top left one of pixel (x, y).
struct BorderStep {
  cv::Point corner;
  cv::Point pixel;
};
using BorderRing = std::vector<BorderStep>;  ///< closed: the last step leads to the first

/// The border of each part of a mask, in the order of their topmost, leftmost pixels. Pixels that
/// share a corner belong to the same part. Holes are cut: the ring leaves its way at a pixel above
/// the hole, goes straight down to it, around it and back the same way.
[[nodiscard]] std::vector<BorderRing> partBorders(const Mask& mask);

/// Where a walk along one ring turns into another.
struct Branch {
  std::size_t ring = 0;   ///< the other one
  std::size_t start = 0;  ///< its step that comes first, and last once more
};

/// By ring and step: all branches that leave there.
using Branches = std::map<std::pair<std::size_t, std::size_t>, std::vector<Branch>>;

/// One ring of several: a walk around `root` that makes, at each branch, the round of the other
/// ring (with that one's own branches) and comes back to the step that it left.
/// @param branches  without circles
[[nodiscard]] BorderRing walk(const std::vector<BorderRing>& rings, const Branches& branches,
                              const Branch& root);

}  // namespace synthetic_dataset::masks

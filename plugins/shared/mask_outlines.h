#pragma once

#include <vector>

#include <opencv2/core/types.hpp>

#include "synthetic_dataset/mask.h"

/// Masks as polygons.
namespace synthetic_dataset::masks {

/// A closed polygon; the last point leads to the first. Its inside follows the even-odd rule.
using Ring = std::vector<cv::Point>;

/// Each part of a mask as a polygon along its pixels' edges, in coordinates in which the image
/// spans 0 .. width (COCO's). Pixels that share a corner belong to the same part. A hole is cut by
/// a seam: a line to the polygon's rim and back. Rasterized by pixel centres, the polygons
/// reproduce the mask; so they do with pycocotools' `frPyObjects`.
/// @return  in the order of their topmost, leftmost pixels; empty for an empty mask
[[nodiscard]] std::vector<Ring> edgeRings(const Mask& mask);

/// The whole mask as one polygon through the centres of its outermost pixels (integer coordinates),
/// for formats with one polygon per instance that is filled including its rim, as by
/// `cv::fillPoly`. Seams that cut holes run inside the mask. Parts are joined by short bridges,
/// each a line there and back: filling yields the mask and the pixels of the bridges.
/// @return  at least three points, some of them repeated if the mask has fewer; empty for an empty
///     mask
[[nodiscard]] Ring centreRing(const Mask& mask);

}  // namespace synthetic_dataset::masks

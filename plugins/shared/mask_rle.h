#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "synthetic_dataset/mask.h"

/// COCO's run-length encoding of masks (https://github.com/cocodataset/cocoapi, common/maskApi.c).
namespace synthetic_dataset::masks {

/// The lengths of the runs of equal pixels, column after column from the top left, turn by turn of
/// pixels off and on the mask; the first one is of pixels off it and may be 0.
[[nodiscard]] std::vector<std::int64_t> columnRuns(const Mask& mask);

/// COCO's compressed `counts`, byte for byte as `pycocotools.mask.encode` makes them.
[[nodiscard]] std::string cocoCounts(const std::vector<std::int64_t>& runs);

}  // namespace synthetic_dataset::masks

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "synthetic_dataset/mask.h"

/// COCO's run-length encoding of masks (https://github.com/cocodataset/cocoapi, common/maskApi.c).
namespace synthetic_dataset::masks {

/// The lengths of the runs of equal pixels, column by column from the top left, alternately off and
/// on the mask; the first run is off the mask and may have length 0.
[[nodiscard]] std::vector<std::int64_t> columnRuns(const Mask& mask);

/// COCO's compressed `counts`, byte for byte as made by `pycocotools.mask.encode`.
[[nodiscard]] std::string cocoCounts(const std::vector<std::int64_t>& runs);

}  // namespace synthetic_dataset::masks

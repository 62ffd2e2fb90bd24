#pragma once

#include <string>

#include "plugins/readback/found_files.h"

namespace synthetic_dataset::formats::kitti {

/// Holds the points of a scan, one of each pixel that has a depth, against the scene's depth.
void compareScan(const std::string& name, const TrueScene& truth, FoundFiles& files);

}  // namespace synthetic_dataset::formats::kitti

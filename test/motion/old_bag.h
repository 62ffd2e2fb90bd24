#pragma once

#include <string>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// The content of a bag of format version 1.2 (until 2010), which librosbag reads but no longer
/// writes: one transform on /tf, as a tf/tfMessage of
/// tf version 1. http://wiki.ros.org/Bags/Format/1.2
[[nodiscard]] std::string oldBag(const std::string& parent, const std::string& child, Stamp stamp,
                                 double x);

}  // namespace synthetic_dataset::motion

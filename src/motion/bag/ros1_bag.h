#pragma once

#include <memory>
#include <string>

#include "motion/bag/bag.h"

namespace synthetic_dataset::motion {

/// Opens a bag of ROS 1.
/// @param file  that exists
/// @throws Error as openBag() does
[[nodiscard]] std::unique_ptr<Bag> openRos1Bag(const std::string& file);

}  // namespace synthetic_dataset::motion

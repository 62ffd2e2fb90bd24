#pragma once

#include <string>
#include <string_view>

#include "motion/ros2/message_layout.h"

namespace synthetic_dataset::motion {

/// A message of ROS 2, as ROS 1 serialises its message of the same type: numbers of CDR (OMG,
/// "DDS-XTypes 1.3", section 7.4, encoding version 1) are aligned to their sizes and of either byte
/// order, texts end with a zero, and headers have no number.
/// @param cdr  with the four bytes before it that say how it is encoded
/// @throws Error where it is encoded otherwise, a length or a count leads beyond its end, or its
/// end
///     is not where the layout says
[[nodiscard]] std::string ros1Serialized(std::string_view cdr, const MessageLayout& layout);

}  // namespace synthetic_dataset::motion

#pragma once

#include <string>
#include <string_view>

#include "motion/ros2/message_layout.h"

namespace synthetic_dataset::motion {

/// Converts a message of ROS 2 to ROS 1's serialisation of the same type. In CDR, numbers (OMG,
/// "DDS-XTypes 1.3", section 7.4, encoding version 1) are aligned to their sizes and of either byte
/// order, texts end with a zero, and headers have no sequence number.
/// @param cdr  including the four leading bytes that identify the encoding
/// @throws Error if it has another encoding, a length or a count leads beyond its end, or its end
///     is not where the layout says
[[nodiscard]] std::string ros1Serialized(std::string_view cdr, const MessageLayout& layout);

}  // namespace synthetic_dataset::motion

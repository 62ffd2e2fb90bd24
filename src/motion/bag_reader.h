#pragma once

#include <functional>
#include <string>
#include <vector>

#include <geometry_msgs/TransformStamped.h>

#include "motion/left_out_transforms.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// When a recording was made: the record times of its first and last message, of any topic.
struct RecordedTimes {
  Stamp start{0};
  Stamp end{0};
};

/// Called for each transform of each message, in the order of record times over all bags.
using TransformVisitor = std::function<void(const geometry_msgs::TransformStamped& transform,
                                            TransformKind kind, const std::string& bag_file)>;

/// Reads the topics `/tf` and `/tf_static` (or `tf` and `tf_static`) of the bags.
/// @throws ErrorList with what is wrong with each of the files: missing, no bag, truncated,
///     messages of another type, or, if none of them has any, no messages or no transforms
RecordedTimes readTransforms(const std::vector<std::string>& bag_files,
                             const TransformVisitor& visit);

}  // namespace synthetic_dataset::motion

#pragma once

#include <string>
#include <vector>

#include "motion/tf/bag_file.h"
#include "motion/tf/bag_reader.h"

namespace synthetic_dataset::motion {

/// The topics that contain a recording's TF.
struct TfTopics {
  TopicReaders readers;
  std::string note;  ///< for the user, if other topics than usual are read; or empty
  std::vector<std::string> ignored;  ///< topics of TF's type that are not read
};

/// Finds `/tf` and `/tf_static` (or `tf` and `tf_static`) in the bags, or, if there are none and
/// only one namespace has such topics, those of that namespace.
/// @param named  topics to read instead; one whose name ends with tf_static contains static
///     transforms
/// @throws ErrorList if messages are of another type, a named topic does not exist, or there are
///     several namespaces
[[nodiscard]] TfTopics findTfTopics(const BagReader& bags,
                                    const std::vector<std::string>& named = {});

/// "bag a.bag: no messages of /tf or /tf_static; its topics are ...", for each bag.
[[nodiscard]] std::vector<std::string> noTransforms(const BagReader& bags);

}  // namespace synthetic_dataset::motion

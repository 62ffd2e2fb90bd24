#pragma once

#include <string>
#include <vector>

#include "motion/tf/bag_file.h"
#include "motion/tf/bag_reader.h"

namespace synthetic_dataset::motion {

/// The topics that have a recording's TF.
struct TfTopics {
  TopicReaders readers;
  std::string note;  ///< that the user should know: other topics than usual; or empty
  std::vector<std::string> ignored;  ///< topics of TF's type that are not read
};

/// Finds `/tf` and `/tf_static` (or `tf` and `tf_static`) in the bags, or, where there are none and
/// one namespace alone has such topics, those of this namespace.
/// @param named  topics that are read instead; a name that ends with tf_static is of static ones
/// @throws ErrorList: messages of another type; a named topic that is not there; several namespaces
[[nodiscard]] TfTopics findTfTopics(const BagReader& bags,
                                    const std::vector<std::string>& named = {});

/// "bag a.bag: no messages of /tf or /tf_static; its topics are ...", for each bag.
[[nodiscard]] std::vector<std::string> noTransforms(const BagReader& bags);

}  // namespace synthetic_dataset::motion

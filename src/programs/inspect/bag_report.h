#pragma once

#include <string>
#include <vector>

#include "motion/bag_contents.h"
#include "programs/inspect/server_descriptions.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// The contents of a recording as text for people: frames as a tree with rate, times and how far
/// each travels; topics; which frames look like robots and cameras; robots' models, in the
/// recording and on the parameter server.
[[nodiscard]] std::string bagText(const motion::BagContents& contents,
                                  const std::vector<ServerDescription>& on_server);

/// The same for programs. Times are numbers in [s], lengths in [m].
[[nodiscard]] Value bagValue(const motion::BagContents& contents,
                             const std::vector<ServerDescription>& on_server);

}  // namespace synthetic_dataset::programs

#pragma once

#include <string>
#include <vector>

#include "motion/bag_contents.h"
#include "programs/inspect/server_descriptions.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// What a recording has, for the eye: frames as a tree with rate, times and how far each travels;
/// topics; which frames look like robots and cameras; robots' models, here and on the parameter
/// server.
[[nodiscard]] std::string bagText(const motion::BagContents& contents,
                                  const std::vector<ServerDescription>& on_server);

/// The same for programs. Times and lengths are numbers [s], [m].
[[nodiscard]] Value bagValue(const motion::BagContents& contents,
                             const std::vector<ServerDescription>& on_server);

}  // namespace synthetic_dataset::programs

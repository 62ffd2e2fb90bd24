#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "motion/tf/joint_frames.h"
#include "scene/object_options.h"
#include "world/description.h"

namespace synthetic_dataset::scene {

/// A link's names as frames may have them: "arm::wrist" is "arm/wrist", or "wrist" where it is the
/// model's only one.
[[nodiscard]] std::vector<std::string> frameNames(const world::Model& model,
                                                  const world::Link& link);

/// The frame of a link of that name by a pattern: "{object}/{link}".
[[nodiscard]] std::string frameByPattern(const std::string& pattern, const std::string& object,
                                         const std::string& link);

/// Whether a frame's name means this link of an object's model: by its `link_frames`, below the
/// same prefix as the object's own frame, or by the link's name alone.
[[nodiscard]] bool isFrameOfLink(const std::string& frame, const std::string& link,
                                 const ObjectOptions& object);

/// The one of these links after which a frame is named, alone or below a prefix: "base_link",
/// "rover_1/base_link".
[[nodiscard]] std::optional<std::size_t> linkNamedBy(const std::string& frame,
                                                     const world::Model& model,
                                                     const std::vector<std::size_t>& links);

/// How an object's links move with its joints, if any of these is known to.
[[nodiscard]] std::optional<motion::JointedRobot> jointedRobot(const world::Model& model,
                                                               const ObjectOptions& object);

}  // namespace synthetic_dataset::scene

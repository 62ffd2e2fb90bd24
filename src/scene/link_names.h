#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "motion/tf/joint_frames.h"
#include "scene/object_options.h"
#include "world/description.h"

namespace synthetic_dataset::scene {

/// The names that a link may have in frames: "arm::wrist" is "arm/wrist", or also "wrist" if the
/// model has only one.
[[nodiscard]] std::vector<std::string> frameNames(const world::Model& model,
                                                  const world::Link& link);

/// The name of a link's frame by a pattern such as "{object}/{link}".
[[nodiscard]] std::string frameByPattern(const std::string& pattern, const std::string& object,
                                         const std::string& link);

/// Whether a frame's name refers to this link of an object's model: by the object's `link_frames`,
/// by the link's name after the prefix of the object's own frame, or by the link's name alone.
[[nodiscard]] bool isFrameOfLink(const std::string& frame, const std::string& link,
                                 const ObjectOptions& object);

/// Which of these links a frame is named after, with or without a prefix: "base_link",
/// "rover_1/base_link".
[[nodiscard]] std::optional<std::size_t> linkNamedBy(const std::string& frame,
                                                     const world::Model& model,
                                                     const std::vector<std::size_t>& links);

/// How an object's links move with its joints; nothing if no joint is known to move.
[[nodiscard]] std::optional<motion::JointedRobot> jointedRobot(const world::Model& model,
                                                               const ObjectOptions& object);

}  // namespace synthetic_dataset::scene

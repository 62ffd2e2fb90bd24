#pragma once

#include <optional>
#include <string>
#include <vector>

#include "randomize/placement/placement_options.h"
#include "scene/object_options.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::config {

/// Whether a group of settings has this name, which no object can have then: its own group would be
/// called the same.
[[nodiscard]] bool isSettingGroup(const std::string& name);

/// Reads `robot_list` and the group of each object in it.
[[nodiscard]] std::vector<scene::ObjectOptions> readObjects(Parameters root);

/// Adds the distractors that are labelled to the objects, in the order of their numbers.
void addLabelledDistractors(Parameters root,
                            const std::optional<randomize::DistractorOptions>& distractors,
                            std::vector<scene::ObjectOptions>& objects);

/// A class's name or an object's id: a text or a number, a word of label files.
[[nodiscard]] std::string readLabel(Parameters group, const std::string& name);

}  // namespace synthetic_dataset::config

#pragma once

#include "config/config.h"

namespace synthetic_dataset::config {

/// Reads `masks` and `background_subtractor`.
[[nodiscard]] label::MaskOptions readMasks(Parameters root);

/// Reads `labels`.
[[nodiscard]] label::LabelOptions readLabels(Parameters root);

/// Reads `split`.
[[nodiscard]] SplitConfig readSplit(Parameters root);

/// Reads `classes` and gives each object its class's number.
///
/// Without `classes`, a class that is a whole number keeps it, and the others take the numbers that
/// are left, from 0 on, in alphabetical order.
/// @return all classes in the order of their numbers
[[nodiscard]] std::vector<ClassConfig> readClasses(Parameters root,
                                                   std::vector<scene::ObjectOptions>& objects);

/// Reads `world_classes`.
/// @param classes  of objects, which have other names
[[nodiscard]] scene::WorldClasses readWorldClasses(Parameters root,
                                                   const std::vector<ClassConfig>& classes);

}  // namespace synthetic_dataset::config

#pragma once

#include "synthetic_dataset/value.h"

/// For the page: which settings and formats exist, and which of them a problem is about.
namespace synthetic_dataset::programs {

/// All settings of config/params.yaml: path, text, unit, whether it is required; and what its
/// reader declares: default, range, choices.
[[nodiscard]] Value parameterList();

/// The formats of docs/formats.md: name, type, what it makes, who reads it, and its settings from
/// the tables of its section, each with what its writer declares about it.
[[nodiscard]] Value formatList();

/// Adds to each problem of a set-up the `path` of the setting at which the page shows it: the one
/// that it is about, an object or a camera that it names, else the first setting that its cure or
/// its text names. Problems that name none have no `path`.
/// @param setup  with `problems`, and `about`, `found` and `cure` in each
/// @param settings  all that are in effect
void addFields(Value::Map& setup, const Value& settings);

}  // namespace synthetic_dataset::programs

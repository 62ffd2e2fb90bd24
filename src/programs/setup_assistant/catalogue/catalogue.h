#pragma once

#include "synthetic_dataset/value.h"

/// What settings and formats there are, for the page, and which of them a problem is about.
namespace synthetic_dataset::programs {

/// All settings of config/params.yaml: path, text, unit, whether it is required; and what their
/// readers declare: default, range, choices.
[[nodiscard]] Value parameterList();

/// The formats of docs/formats.md: name, type, what it makes, who reads it, and its settings from
/// the tables of its section, each with what its writer declares of it.
[[nodiscard]] Value formatList();

/// Gives each problem of a set-up the setting that the page shows it at, as its `path`: the one
/// that it is about, an object or a camera that it names, else the first setting that its cure or
/// its text names. Problems that name none keep none.
/// @param setup  with `problems`, and `about`, `found` and `cure` in each
/// @param settings  all that hold
void addFields(Value::Map& setup, const Value& settings);

}  // namespace synthetic_dataset::programs

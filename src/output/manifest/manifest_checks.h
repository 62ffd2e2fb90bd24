#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/sqlite.h"
#include "output/manifest/manifest_content.h"

/// What is wrong with a manifest itself, whatever the files are like that it lists: a line each.
namespace synthetic_dataset::output {

/// Damage that keeps a manifest from being read: SQLite finds its file broken, it has another
/// version, other tables, or values of other kinds than the tables are made for.
/// @param manifest  its path
[[nodiscard]] std::vector<std::string> structureProblems(const std::string& manifest);

/// Of a manifest of the right structure: what the run's facts, scenes and rows do not agree in.
/// @param content  what `readWithoutFiles` says of it
[[nodiscard]] std::vector<std::string> contentProblems(const std::string& manifest,
                                                       const ManifestContent& content);

}  // namespace synthetic_dataset::output

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/sqlite.h"
#include "output/manifest/manifest_content.h"

/// Checks a manifest itself, whatever state its files are in: returns one line for each problem.
namespace synthetic_dataset::output {

/// Damage that keeps a manifest from being read: SQLite finds the file corrupt, or it has another
/// version, other tables, or values of other types than the tables expect.
/// @param manifest  its path
[[nodiscard]] std::vector<std::string> structureProblems(const std::string& manifest);

/// For a manifest with a valid structure: inconsistencies between the run's facts, scenes and rows.
/// @param content  what `readWithoutFiles` returns for it
[[nodiscard]] std::vector<std::string> contentProblems(const std::string& manifest,
                                                       const ManifestContent& content);

}  // namespace synthetic_dataset::output

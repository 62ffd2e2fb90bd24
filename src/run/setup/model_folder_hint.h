#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace synthetic_dataset::run {

/// Where models and their files that were not found may lie: the folder near a world's file that
/// has the most of them. Worlds are often handed on with their models, whose folder only the
/// environment of their author names.
/// @param uris  that were not found; those count that name a model (model://, package://)
/// @return an error's message; empty where no folder has any of them
[[nodiscard]] std::string modelFolderHint(const std::filesystem::path& world_file,
                                          const std::set<std::string>& uris);

}  // namespace synthetic_dataset::run

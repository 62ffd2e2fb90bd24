#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace synthetic_dataset::run {

/// Suggests where models and their files that were not found may be: the folder near a world's file
/// that contains the most of them. Worlds are often passed on together with their models, but only
/// their author's environment names the models' folder.
/// @param uris  that were not found; only those that name a model (model://, package://) count
/// @return an error's message; empty if no folder has any of them
[[nodiscard]] std::string modelFolderHint(const std::filesystem::path& world_file,
                                          const std::set<std::string>& uris);

}  // namespace synthetic_dataset::run

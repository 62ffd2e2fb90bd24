#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "programs/setup_assistant/folders/allowed_folders.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// What a file may be used for, by its name and how it begins: "bag", "world", "model",
/// "calibration", "yaml", or "other".
[[nodiscard]] std::string kindOfFile(const std::filesystem::path& file);

/// The folders and files in a folder, for the page, without hidden ones and those that lead out of
/// the allowed folders.
/// @param folder  empty: the roots
/// A folder that is a bag of ROS 2 is among both.
/// @param kinds  of files that are listed; empty: all
/// @throws HttpError 403 as AllowedFolders::resolve
[[nodiscard]] Value listFolder(const AllowedFolders& allowed, const std::string& folder,
                               const std::set<std::string>& kinds);

}  // namespace synthetic_dataset::programs

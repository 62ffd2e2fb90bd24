#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "programs/setup_assistant/folders/allowed_folders.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// The kind of a file, by its name and its beginning: "bag", "world", "model", "calibration",
/// "yaml", or "other".
[[nodiscard]] std::string kindOfFile(const std::filesystem::path& file);

/// The folders and files in a folder, for the page, without hidden ones and those that lead out of
/// the allowed folders. A folder that is a ROS 2 bag is listed as both.
/// @param folder  empty: the roots
/// @param kinds  of files to list; empty: all
/// @throws HttpError 403 as AllowedFolders::resolve
[[nodiscard]] Value listFolder(const AllowedFolders& allowed, const std::string& folder,
                               const std::set<std::string>& kinds);

}  // namespace synthetic_dataset::programs

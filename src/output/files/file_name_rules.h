#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace synthetic_dataset::output {

/// The path from the root and without `.` and `..`; symbolic links are left as they are.
[[nodiscard]] std::string absolutePath(const std::string& path);

/// Whether a path is a folder or something below it; both absolute and normalised, the folder with
/// or without a trailing `/`.
[[nodiscard]] bool liesWithin(std::string_view path, std::string_view folder);

/// The files that are outside all of these folders, judged by their path and by the real path after
/// resolving symbolic links to folders.
/// @param files, folders  absolute and normalised; a folder may itself be reached through links
[[nodiscard]] std::vector<std::string> filesOutside(const std::vector<std::string>& files,
                                                    const std::vector<std::string>& folders);

/// "'a', 'b', 'c' and more"
[[nodiscard]] std::string firstNames(const std::vector<std::string>& names);

}  // namespace synthetic_dataset::output

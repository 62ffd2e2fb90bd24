#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace synthetic_dataset::output {

/// The path from the root and without `.` and `..`; symbolic links are left as they are.
[[nodiscard]] std::string absolutePath(const std::string& path);

/// Whether a path is a folder's or one below it; both absolute and normalised, the folder with a
/// `/` at its end or not.
[[nodiscard]] bool liesWithin(std::string_view path, std::string_view folder);

/// Those files that lie in none of these folders, by their path or through a symbolic link to a
/// folder on it.
/// @param files, folders  absolute and normalised; a folder may itself be reached through links
[[nodiscard]] std::vector<std::string> filesOutside(const std::vector<std::string>& files,
                                                    const std::vector<std::string>& folders);

/// "'a', 'b', 'c' and more"
[[nodiscard]] std::string firstNames(const std::vector<std::string>& names);

}  // namespace synthetic_dataset::output

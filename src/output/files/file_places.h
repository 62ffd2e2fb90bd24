#pragma once

#include <string>
#include <vector>

namespace synthetic_dataset::output {

/// Those files that lie in none of these folders, by their path or through a symbolic link to a
/// folder on it.
/// @param files, folders  absolute and normalised; a folder may itself be reached through links
[[nodiscard]] std::vector<std::string> filesOutside(const std::vector<std::string>& files,
                                                    const std::vector<std::string>& folders);

/// "'a', 'b', 'c' and more"
[[nodiscard]] std::string firstNames(const std::vector<std::string>& names);

}  // namespace synthetic_dataset::output

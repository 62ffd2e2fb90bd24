#pragma once

#include <string>

namespace synthetic_dataset::programs {

/// Gives a file a new content, so that it has the old one or the new one at any time, whatever
/// happens. It keeps its permissions; a symbolic link stays one.
/// @throws Error when it cannot be written
void writeWhole(const std::string& file, const std::string& content);

}  // namespace synthetic_dataset::programs

#pragma once

#include <string>
#include <vector>

namespace synthetic_dataset::motion {

/// tf (version 1) wrote frames with a leading slash, tf2 refuses it: "/map" is "map".
[[nodiscard]] std::string withoutLeadingSlashes(const std::string& frame);

/// "; did you mean 'alpha/base_link'?" for the end of a message, or nothing when no frame is alike:
/// the frames that differ by separators, case or a prefix only ("alpha/" too few or many), else the
/// one that a typing mistake may have meant.
[[nodiscard]] std::string didYouMeanFrame(const std::string& name,
                                          const std::vector<std::string>& frames);

}  // namespace synthetic_dataset::motion

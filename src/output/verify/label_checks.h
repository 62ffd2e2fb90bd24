#pragma once

#include <string>
#include <vector>

#include "output/manifest/picture_facts.h"
#include "output/manifest/run_description.h"
#include "plugins/readback/drawn_label.h"

namespace synthetic_dataset::output {

/// How the labels that a format's files have of a scene differ from those of the right files, in
/// words: a line for each that is wrong, one that should not be there, one that is missing.
/// @param facts, run  what the manifest has of the scene and of its objects, to name them
[[nodiscard]] std::vector<std::string> labelProblems(const formats::LabelledPicture& found,
                                                     const formats::LabelledPicture& right,
                                                     const SceneFacts& facts,
                                                     const RunDescription& run);

/// How the time, the poses and the pixels that the manifest has of a scene differ from those of a
/// new drawing.
[[nodiscard]] std::vector<std::string> poseProblems(const SceneFacts& found,
                                                    const SceneFacts& drawn,
                                                    const RunDescription& run);

}  // namespace synthetic_dataset::output
